#version 300 es
// Bloom prefilter: radiance at a quarter of the size, cd/m².
#include "lib/precision.glsl"

uniform sampler2D uSource;

in vec2 vUv;

out vec4 oRadiance;

void main() {
  vec2 texel = 1.0 / vec2(textureSize(uSource, 0));
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 4; i++) {
    sum += textureLod(uSource, vUv + vec2(i & 1, i >> 1) * 2.0 * texel - texel, 0.0).rgb;
  }
  oRadiance = vec4(sum * 0.25, 1.0);
}
