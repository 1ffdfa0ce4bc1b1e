// The display transform as a table of exposed, white-balanced light: by the roots of green's and blue's shares, as
// vibrance depends on hue alone, and by the fourth root of the sum. Squares of hues lie side by side, one for each level.

const float TONE_LUT_SIZE = 40.0;
// Sum of the channels at the end of the table, where white is about 3.
const float TONE_LUT_MAX = 36.0;
// Least share of a channel in the hues that the table resolves; embers and the blue base of the flame have less.
const float TONE_LUT_LEAST = 0.03;

uniform sampler2D uToneLut;

// Display colour of white-balanced light, given as a share of TONE_LUT_MAX. Beyond the table it keeps its hue.
vec3 lookUpTone(vec3 light) {
  float sum = light.r + light.g + light.b;
  float level = sqrt(sqrt(min(sum, 1.0))) * (TONE_LUT_SIZE - 1.0);
  float lower = min(floor(level), TONE_LUT_SIZE - 2.0);
  vec2 texel = sqrt(light.gb / max(sum, 1e-9)) * (TONE_LUT_SIZE - 1.0) + 0.5;
  vec2 uv = (texel / TONE_LUT_SIZE + vec2(lower, 0.0)) / vec2(TONE_LUT_SIZE, 1.0);
  vec3 color = textureLod(uToneLut, uv, 0.0).rgb;
  return mix(color, textureLod(uToneLut, uv + vec2(1.0 / TONE_LUT_SIZE, 0.0), 0.0).rgb, level - lower);
}
