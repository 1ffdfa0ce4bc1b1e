#version 300 es
// Vertices of a mesh: the room, or the candle at its placement.
// DEPTH_BIAS: farther by so much of the depth, 0 to 1: what is drawn again passes the test.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/mesh-vertex.glsl"

uniform vec4 uPlacement;  // of the model's origin, m; w: yaw, rad

centroid out vec3 vPositionWorld;
centroid out vec3 vNormalWorld;
centroid out vec4 vTangentWorld;
centroid out vec2 vUv;
centroid out vec4 vColor;

vec3 rotateYaw(vec3 v) {
  float c = cos(uPlacement.w);
  float s = sin(uPlacement.w);
  return vec3(c * v.x + s * v.z, v.y, c * v.z - s * v.x);
}

void main() {
  vPositionWorld = uPlacement.xyz + rotateYaw(aPosition);
  vNormalWorld = rotateYaw(aNormal);
  vTangentWorld = vec4(rotateYaw(aTangent.xyz), aTangent.w);
  vUv = aUv;
  vColor = aColor;
  gl_Position = frame.clipFromWorld * vec4(vPositionWorld, 1.0);
#ifdef DEPTH_BIAS
  gl_Position.z += 2.0 * DEPTH_BIAS * gl_Position.w;
#endif
}
