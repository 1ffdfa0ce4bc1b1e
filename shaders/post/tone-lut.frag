#version 300 es
// The tone LUT.   Out: display colour, without dither.
#include "lib/precision.glsl"
#include "lib/display-transform.glsl"
#include "lib/tone-lut.glsl"

out vec4 oColor;

void main() {
  vec2 texel = floor(gl_FragCoord.xy);
  float level = floor(texel.x / TONE_LUT_SIZE);
  vec2 hue = (texel - vec2(level * TONE_LUT_SIZE, 0.0)) / (TONE_LUT_SIZE - 1.0);
  hue *= hue;
  level /= TONE_LUT_SIZE - 1.0;
  level *= level;
  vec3 light = vec3(max(1.0 - hue.x - hue.y, 0.0), hue) * (level * level * TONE_LUT_MAX);
  oColor = vec4(toneAndEncode(light * uWhite), 1.0);
}
