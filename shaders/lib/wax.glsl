// Subsurface scattering of a taper: light that enters the wax at its top and leaves through its side.
// Needs lib/photometry.glsl, lib/flame-light.glsl.

// Diffusion length, m: 14, 10.5 and 7 mm in thick paraffin; less in a taper, which loses more through its side.
const vec3 DIFFUSION_LENGTH = vec3(0.0092, 0.0078, 0.0056);
// Share of the light on the top that leaves through the side.
const float WAX_TRANSMITTANCE = 0.0223;
// Least height of the flame over the top, m.
const float LEAST_HEIGHT = 0.01;

// Wax of other candles than the flame's own begins farther from its axis, m.
const float WAX_REACH = 0.06;

// Distance at which light that scatters in wax blurs its relief, m, and the share of a normal's slope that it leaves.
const float SCATTERED = 0.002;
const float SLOPE_LEFT = 0.4;

bool isOwnWax(vec3 position) {
  return distance(position.xz, light.axis) < WAX_REACH;
}

// Cosine to the flame on wax: gradually 0 where the flame sinks below the horizon.
float softCosine(vec3 normal, vec3 toLight) {
  float extent = light.radius + light.halfHeight * abs(dot(light.along, normal)) + SCATTERED;
  float height = dot(normal, toLight);
  float above = clamp(height + extent, 0.0, 2.0 * extent);
  return max(above * above / (4.0 * extent), height) * inversesqrt(dot(toLight, toLight));
}

// The same on a taper. `surface`: normal of the mesh.
float waxCosine(vec3 surface, vec3 position, vec3 toLight) {
  if (isOwnWax(position)) {
    vec2 outward = position.xz - light.axis;
    outward *= max(dot(outward, surface.xz), 0.0) / (dot(outward, outward) + 1e-9);
    surface = normalize(mix(vec3(outward.x, 0.0, outward.y), surface, SLOPE_LEFT));
  }
  return softCosine(surface, toLight);
}

// Radiosity of wax of an albedo of 1, for 1 cd, lm/m²: of the light on its top, the share `transmittance` leaves below, less
// with the depth. `diffusionLength`: m.
vec3 waxTransmission(vec3 position, vec3 diffusionLength, float transmittance) {
  float height = max(light.position.y - light.rim, LEAST_HEIGHT);
  float way = length(vec3(position.xz - light.axis, height));
  return exp(-max(light.rim - position.y, 0.0) / diffusionLength) * (transmittance * height / (way * way * way));
}

// The same of a taper.
vec3 taperTransmission(vec3 position) {
  return waxTransmission(position, DIFFUSION_LENGTH, WAX_TRANSMITTANCE);
}

// Radiance for an albedo of 1, cd/m².
vec3 waxGlow(vec3 position) {
  return isOwnWax(position) ? light.intensity / PI * taperTransmission(position) : vec3(0.0);
}
