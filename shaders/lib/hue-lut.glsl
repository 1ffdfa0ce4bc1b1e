// Lookup of the vibrance in a 2D table of half floats: it depends on hue alone, and scales with the light.
// Needs lib/chromatic-adaptation.glsl.

const float HUE_LUT_SIZE = 64.0;
// Least share of a channel in the hues that the table resolves; embers and the blue base of the flame have less.
const float HUE_LUT_LEAST = 0.03;

uniform sampler2D uHueLut;  // vivid light by the shares of red and blue in white-balanced light

// Adapted, vivid light from white-balanced light.
vec3 lookUpVibrance(vec3 balanced) {
  float sum = balanced.r + balanced.g + balanced.b;
  vec2 hue = balanced.rb / max(sum, 1e-9);
  vec2 uv = hue * ((HUE_LUT_SIZE - 1.0) / HUE_LUT_SIZE) + 0.5 / HUE_LUT_SIZE;
  vec3 vivid = textureLod(uHueLut, uv, 0.0).rgb * sum;
  // Software renderers execute both sides of an `if`, but skip a loop that no pixel enters.
  int exact = min(min(balanced.r, balanced.g), balanced.b) < HUE_LUT_LEAST * sum ? 1 : 0;
  for (int i = 0; i < exact; i++) vivid = applyVibrance(balanced * uWhite);
  return vivid;
}
