#version 300 es
// A blurred level of the pyramid, widened by a tent of 9 taps, or 4 where they are dear, to be added to the next
// finer one.   In:  radiance at half the size.   Out: radiance.
#include "lib/precision.glsl"

uniform sampler2D uSource;
uniform float uShare;

out vec4 oRadiance;

void main() {
  vec2 texel = 1.0 / vec2(textureSize(uSource, 0));
  vec2 middle = 0.5 * gl_FragCoord.xy * texel;
  vec3 sum = vec3(0.0);
#if FRUGAL
  for (int corner = 0; corner < 4; corner++) {
    sum += 4.0 * texture(uSource, middle + (vec2(corner & 1, corner >> 1) - 0.5) * texel).rgb;
  }
#else
  for (int y = -1; y <= 1; y++) {
    for (int x = -1; x <= 1; x++) {
      float weight = float((2 - abs(x)) * (2 - abs(y)));
      sum += weight * texture(uSource, middle + vec2(x, y) * texel).rgb;
    }
  }
#endif
  // Premultiplied blending: this level takes its share, the finer one keeps the rest.
  oRadiance = vec4(sum / 16.0 * uShare, uShare);
}
