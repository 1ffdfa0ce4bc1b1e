#version 300 es
// Out: distance from the flame, m.
#include "lib/precision.glsl"

uniform vec3 uLight;

in vec3 vPositionWorld;

out vec4 oDistance;

void main() {
  oDistance = vec4(distance(vPositionWorld, uLight), 0.0, 0.0, 1.0);
}
