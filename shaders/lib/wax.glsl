// Subsurface scattering of a taper: light that enters the wax at its top and leaves through its side.
// Needs lib/photometry.glsl, lib/flame-light.glsl.

// Diffusion length, m: 14, 10.5 and 7 mm in thick paraffin; less in a taper, which loses more through its side.
const vec3 DIFFUSION_LENGTH = vec3(0.0092, 0.0078, 0.0056);
// Share of the light on the top that leaves through the side.
const float WAX_TRANSMITTANCE = 0.02;
// Least height of the flame over the top, m.
const float LEAST_HEIGHT = 0.01;

// Wax of other candles than the flame's own begins farther from its axis, m.
const float WAX_REACH = 0.06;

// Radiosity of wax of an albedo of 1, for 1 cd, lm/m².
vec3 waxTransmission(vec3 position) {
  float depth = max(light.rim - position.y, 0.0);
  float height = max(light.position.y - light.rim, LEAST_HEIGHT);
  return exp(-depth / DIFFUSION_LENGTH) * (WAX_TRANSMITTANCE / (height * height + 1e-4));
}

// Radiance for an albedo of 1, cd/m².
vec3 waxGlow(vec3 position) {
  if (distance(position.xz, light.axis) > WAX_REACH) return vec3(0.0);
  return light.intensity / PI * waxTransmission(position);
}
