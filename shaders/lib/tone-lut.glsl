// The display transform as a 3D table over the fourth roots of exposed, white-balanced light.

precision highp sampler3D;

const float TONE_LUT_SIZE = 32.0;
// Light at the end of the table, where white is about 1.
const float TONE_LUT_MAX = 12.0;

uniform sampler3D uToneLut;

// Display colour of white-balanced light, given as a share of TONE_LUT_MAX, at most 1.
vec3 lookUpTone(vec3 light) {
  vec3 uvw = sqrt(sqrt(light));
  return texture(uToneLut, uvw * ((TONE_LUT_SIZE - 1.0) / TONE_LUT_SIZE) + 0.5 / TONE_LUT_SIZE).rgb;
}

// The same of light that may exceed the table: it keeps its hue.
vec3 lookUpTonePreservingHue(vec3 light) {
  return lookUpTone(light / max(max(light.r, light.g), max(light.b, 1.0)));
}
