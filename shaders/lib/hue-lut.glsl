// Lookup of the vibrance, which is of the hue alone: it scales with the light, as a 2D table of half floats.
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
  // A software renderer runs both sides of an if, but leaves a loop that no pixel is in.
  int exact = min(min(balanced.r, balanced.g), balanced.b) < HUE_LUT_LEAST * sum ? 1 : 0;
  for (int i = 0; i < exact; i++) vivid = applyVibrance(balanced * uWhite);
  return vivid;
}
