// Single scattering by fine droplets.
// Needs lib/photometry.glsl; unless ALONE is defined, also lib/flame-light.glsl and lib/irradiance-volume.glsl.

// Albedo of droplets smaller than a wavelength: more of blue than of red.
const vec3 DROPLET_ALBEDO = vec3(0.95, 1.0, 1.1);
// Anisotropy g of the phase function.
const float ANISOTROPY = 0.45;

// Henyey and Greenstein 1941, "Diffuse Radiation in the Galaxy". 1/sr.
float phase(float cosine) {
  float g = ANISOTROPY;
  return (1.0 - g * g) / (4.0 * PI * pow(1.0 + g * g - 2.0 * g * cosine, 1.5));
}

vec3 scatteredDirect(vec3 intensity, vec3 toLight, vec3 toEye) {
  float distanceSquared = dot(toLight, toLight);
  float cosine = -dot(toLight, toEye) * inversesqrt(max(distanceSquared * dot(toEye, toEye), 1e-12));
  return intensity * (phase(cosine) / max(distanceSquared, 2.5e-5));  // no nearer than 5 mm
}

#ifndef ALONE
uniform vec3 uMoonlight;  // scattered by droplets, cd/m²

// Mean of the irradiance from above and from below: a droplet has no normal.
vec3 scatteredIndirect(vec3 position) {
  IrradianceSample upDown = irradianceAt(position, 0.0, vec3(0.0), vec3(0.0, 1.0, 0.0), vec3(0.0, -1.0, 0.0));
  return (upDown.alongNormal + upDown.alongReflection) * light.intensity / (2.0 * PI);
}

// Radiance of optically thick smoke, cd/m², with a share of the flame's direct light.
vec3 scatteredRadiance(vec3 position, vec3 eye, float share) {
  vec3 direct = scatteredDirect(share * light.intensity, light.position - position, eye - position);
  return DROPLET_ALBEDO * (direct * candleVisibility(position) + scatteredIndirect(position) + uMoonlight);
}
#endif
