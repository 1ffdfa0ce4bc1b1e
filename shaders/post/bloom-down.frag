#version 300 es
// Half of the picture, each texel from 13 taps, so that small bright things neither flicker nor box.
// In:  radiance.   Out: radiance at half the size; energy is kept.
// Jimenez 2014, "Next Generation Post Processing in Call of Duty: Advanced Warfare".
#include "lib/precision.glsl"

uniform sampler2D uSource;

out vec4 oRadiance;

void main() {
  vec2 texel = 1.0 / vec2(textureSize(uSource, 0));
  // Each texel lies over the corner of four, whatever the sizes: so all of them count alike.
  vec2 middle = 2.0 * gl_FragCoord.xy * texel;
  vec3 inner = vec3(0.0);
  vec3 outer = vec3(0.0);
  for (int y = -1; y <= 1; y += 2) {
    for (int x = -1; x <= 1; x += 2) {
      inner += texture(uSource, middle + vec2(x, y) * texel).rgb;
    }
  }
  for (int y = -1; y <= 1; y++) {
    for (int x = -1; x <= 1; x++) {
      float weight = float((2 - abs(x)) * (2 - abs(y)));
      outer += weight * texture(uSource, middle + 2.0 * vec2(x, y) * texel).rgb;
    }
  }
  oRadiance = vec4(inner * 0.125 + outer * (0.5 / 16.0), 1.0);
}
