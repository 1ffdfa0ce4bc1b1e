#version 300 es
// Bloom downsampling: half the size by 13 taps, which suppress flicker of small highlights. Energy is conserved.
// Jimenez 2014, "Next Generation Post Processing in Call of Duty: Advanced Warfare".
#include "lib/precision.glsl"

uniform sampler2D uSource;

out vec4 oRadiance;

void main() {
  vec2 texel = 1.0 / vec2(textureSize(uSource, 0));
  // The corner that four source texels share, at every size, so that all of them have the same weight.
  vec2 centre = 2.0 * gl_FragCoord.xy * texel;
  vec3 inner = vec3(0.0);
  vec3 outer = vec3(0.0);
  for (int y = -1; y <= 1; y += 2) {
    for (int x = -1; x <= 1; x += 2) {
      inner += texture(uSource, centre + vec2(x, y) * texel).rgb;
    }
  }
  for (int y = -1; y <= 1; y++) {
    for (int x = -1; x <= 1; x++) {
      float weight = float((2 - abs(x)) * (2 - abs(y)));
      outer += weight * texture(uSource, centre + 2.0 * vec2(x, y) * texel).rgb;
    }
  }
  oRadiance = vec4(inner * 0.125 + outer * (0.5 / 16.0), 1.0);
}
