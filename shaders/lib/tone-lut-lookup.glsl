// The display's law, looked up.
// Needs lib/tone-lut.glsl.

precision highp sampler3D;

uniform sampler3D uTable;

// What is on the screen of light as a share of TABLE_LIGHT, at most 1, white things having as much of each.
vec3 tabled(vec3 light) {
  vec3 place = sqrt(sqrt(light));
  return texture(uTable, place * ((TABLE_SIZE - 1.0) / TABLE_SIZE) + 0.5 / TABLE_SIZE).rgb;
}
