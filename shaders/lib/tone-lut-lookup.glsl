// Lookup of the display transform. Needs lib/tone-lut.glsl.

precision highp sampler3D;

uniform sampler3D uToneLut;

// Display colour of white-balanced light, given as a share of TONE_LUT_MAX, at most 1.
vec3 lookUpTone(vec3 light) {
  vec3 uvw = sqrt(sqrt(light));
  return texture(uToneLut, uvw * ((TONE_LUT_SIZE - 1.0) / TONE_LUT_SIZE) + 0.5 / TONE_LUT_SIZE).rgb;
}
