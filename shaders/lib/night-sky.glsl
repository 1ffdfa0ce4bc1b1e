// The night behind the window: a faint sky, the line of a wood, the moon.
// Needs lib/moon.glsl.
#include "lib/random.glsl"

// Of the moon, by its solid angle of 0.52 degrees for 1 lx, cd/m².
const float MOON_LUMINANCE = 15400.0;
// Variation of the line of trees, as a slope.
const float UNEVENNESS = 0.08;
// Loss in a pane at normal incidence, beside its reflection.
const float PANE_TRANSMITTANCE = 0.9;

// `turn`: share of a turn; `cells`: in a turn.
float treeNoise(float turn, float cells, uint seed) {
  float x = fract(turn) * cells;
  float cell = floor(x);
  float share = x - cell;
  float a = unit(pcg(uint(cell) + seed));
  float b = unit(pcg(uint(mod(cell + 1.0, cells)) + seed));
  return mix(a, b, share * share * (3.0 - 2.0 * share));
}

// Luminance in a direction of length 1, cd/m², for 1 lx.
float nightLuminance(vec3 direction) {
  float turn = atan(direction.x, -direction.z) / (2.0 * PI);
  float slope = direction.y / max(length(direction.xz), 1e-3);
  float line = treeNoise(turn, 57.0, 1u) + 0.5 * treeNoise(turn, 195.0, 1000u) + 0.25 * treeNoise(turn, 565.0, 2000u);
  float edge = TREES + UNEVENNESS * (line / 1.75 - 0.5);
  float luminance = moon.sky * nightShare(slope, edge);
  float offAxis = length(cross(direction, moon.direction));
  bool isAhead = dot(direction, moon.direction) < 0.0 && slope > edge;
  float disc = isAhead ? 1.0 - smoothstep(0.9 * MOON_TANGENT, 1.1 * MOON_TANGENT, offAxis) : 0.0;
  return luminance + disc * MOON_LUMINANCE;
}

// Through a pane, seen along `direction`; `NoV`: cosine to the pane's normal.
float nightThroughPane(vec3 direction, float NoV) {
  float fresnel = fresnelSchlick(vec3(0.04), NoV).r;
  return PANE_TRANSMITTANCE * (1.0 - fresnel) * nightLuminance(direction);
}
