#version 300 es
// Distance from a flame.   Out: m.
#include "lib/precision.glsl"

uniform vec3 uFlame;  // m

in vec3 vPositionWorld;

out vec4 oDistance;

void main() {
  oDistance = vec4(distance(vPositionWorld, uFlame), 0.0, 0.0, 1.0);
}
