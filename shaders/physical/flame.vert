#version 300 es
// The hull of the flame: a prism around its leaning axis, within which rays are marched.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "physical/flame.glsl"

out vec3 vPositionWorld;

void main() {
  // 14 strip vertices of a cube. Its bottom is at the base of the flame, its top at the tip.
  int corner = int[14](3, 7, 1, 5, 4, 7, 6, 3, 2, 1, 0, 4, 2, 6)[gl_VertexID];
  vec3 unit = vec3(corner & 1, (corner >> 1) & 1, (corner >> 2) & 1);
  float reach = flame.radius * BODY_REACH * 1.05;
  vec3 foot = flame.base + vec3(unit.x * 2.0 - 1.0, 0.0, unit.z * 2.0 - 1.0) * reach;
  vPositionWorld = foot + (flame.tip - flame.base) * unit.y;
  gl_Position = frame.clipFromWorld * vec4(vPositionWorld, 1.0);
}
