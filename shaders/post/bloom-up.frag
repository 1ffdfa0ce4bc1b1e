#version 300 es
// Bloom upsampling: one level, widened by a tent of 9 taps (FRUGAL: 4), blended into the next finer one.
#include "lib/precision.glsl"

uniform sampler2D uSource;
uniform float uWeight;  // of this level against the finer one

out vec4 oRadiance;

void main() {
  vec2 texel = 1.0 / vec2(textureSize(uSource, 0));
  vec2 centre = 0.5 * gl_FragCoord.xy * texel;
  vec3 sum = vec3(0.0);
#if FRUGAL
  for (int i = 0; i < 4; i++) {
    sum += 4.0 * texture(uSource, centre + (vec2(i & 1, i >> 1) - 0.5) * texel).rgb;
  }
#else
  for (int y = -1; y <= 1; y++) {
    for (int x = -1; x <= 1; x++) {
      float weight = float((2 - abs(x)) * (2 - abs(y)));
      sum += weight * texture(uSource, centre + vec2(x, y) * texel).rgb;
    }
  }
#endif
  // Premultiplied blending leaves the finer level 1 - uWeight.
  oRadiance = vec4(sum / 16.0 * uWeight, uWeight);
}
