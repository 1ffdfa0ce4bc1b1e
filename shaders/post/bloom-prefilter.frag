#version 300 es
// Bloom prefilter: radiance at a quarter of the size, times the share of the light that the bloom has from there on, cd/m².
#include "lib/precision.glsl"

uniform sampler2D uSource;

// Two finer levels of a whole frame's bloom each leave 0.7 to the coarser ones.
const float COARSER_SHARE = 0.7 * 0.7;

out vec4 oRadiance;

void main() {
  vec2 texel = 1.0 / vec2(textureSize(uSource, 0));
  // The middle of 4 x 4 source texels, at every size, so that all of them have the same weight.
  vec2 centre = 4.0 * gl_FragCoord.xy * texel;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 4; i++) {
    sum += textureLod(uSource, centre + vec2(i & 1, i >> 1) * 2.0 * texel - texel, 0.0).rgb;
  }
  oRadiance = vec4(sum * (0.25 * COARSER_SHARE), 1.0);
}
