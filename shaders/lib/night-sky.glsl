// The night behind the window: a faint sky, the line of a wood, the moon.
// Needs lib/moon.glsl, lib/random.glsl.

// Luminances as shares of the sky's: the wood; the moon, by its solid angle of 0.52 degrees for 1 lx.
const float WOOD = 0.06;
const float MOON_LUMINANCE = 15400.0;
// Trees over the horizon: mean height of their line and its variation, as slopes.
const float TREES = -0.01;
const float UNEVENNESS = 0.08;
// Loss in a pane at normal incidence, beside its reflection.
const float PANE_TRANSMITTANCE = 0.9;

float treeNoise(float x, uint seed) {
  float cell = floor(x);
  float share = x - cell;
  float a = unit(pcg(uint(int(cell) + 32768) + seed));
  float b = unit(pcg(uint(int(cell) + 32769) + seed));
  return mix(a, b, share * share * (3.0 - 2.0 * share));
}

// Luminance in a direction of length 1, cd/m², for 1 lx.
float nightLuminance(vec3 direction) {
  float azimuth = atan(direction.x, -direction.z);
  float slope = direction.y / max(length(direction.xz), 1e-3);
  float line = treeNoise(azimuth * 9.0, 1u) + 0.5 * treeNoise(azimuth * 31.0, 2u) + 0.25 * treeNoise(azimuth * 90.0, 3u);
  float edge = TREES + UNEVENNESS * (line / 1.75 - 0.5);
  // Brighter towards the horizon, by scattering in the air.
  float sky = moon.sky * (1.0 + 0.5 * exp(-4.0 * max(slope, 0.0)));
  float luminance = mix(moon.sky * WOOD, sky, smoothstep(-0.004, 0.004, slope - edge));
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
