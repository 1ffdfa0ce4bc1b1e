#version 300 es
// A normal map's slope of 45 degrees: as it is, doubled, and halved, as its z.
#include "lib/precision.glsl"
#include "lib/normal-map.glsl"

out vec4 oColor;

void main() {
  vec2 texel = vec2(0.5 + 0.5 * sqrt(0.5), 0.5);
  oColor = vec4(tangentNormal(texel, 1.0).z, tangentNormal(texel, 2.0).z, tangentNormal(texel, 0.5).z, 1.0);
}
