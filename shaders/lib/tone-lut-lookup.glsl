// The display's law, looked up.
// Needs lib/tone-lut.glsl.

precision highp sampler3D;

uniform sampler3D uToneLut;

// What is on the screen of light as a share of TONE_LUT_MAX, at most 1, white things having as much of each.
vec3 tabled(vec3 light) {
  vec3 place = sqrt(sqrt(light));
  return texture(uToneLut, place * ((TONE_LUT_SIZE - 1.0) / TONE_LUT_SIZE) + 0.5 / TONE_LUT_SIZE).rgb;
}
