#version 300 es
// Places as colours, m: 8 m more, so that none is negative.
#include "lib/precision.glsl"

centroid in vec3 vPositionWorld;

out vec4 oColor;

void main() {
  oColor = vec4(vPositionWorld + 8.0, 1.0);
}
