// Light that fine droplets scatter towards the eye.
// Needs lib/octahedral.glsl, lib/photometry.glsl, lib/flame-light.glsl, lib/irradiance-volume.glsl.
#include "lib/night.glsl"

// Droplets smaller than light is long scatter blue better than red.
const vec3 SCATTERED = vec3(0.95, 1.0, 1.1);
// How much more of it goes on ahead than back.
const float FORWARD = 0.45;

// Henyey and Greenstein 1941, "Diffuse Radiation in the Galaxy". 1/sr.
float phase(float cosine) {
  float g = FORWARD;
  return (1.0 - g * g) / (4.0 * PI * pow(1.0 + g * g - 2.0 * g * cosine, 1.5));
}

vec3 scatteredFromFlame(vec3 intensity, vec3 toLight, vec3 toEye) {
  float distanceSquared = dot(toLight, toLight);
  float cosine = -dot(toLight, toEye) * inversesqrt(max(distanceSquared * dot(toEye, toEye), 1e-12));
  return intensity * (phase(cosine) / max(distanceSquared, 2.5e-5));  // no nearer than 5 mm
}

// What the room throws back, from all around, whose mean counts: a droplet has no front.
vec3 scatteredFromRoom(vec3 position) {
  IrradiancePair sides = irradianceAt(position, vec3(0.0), vec3(0.0, 1.0, 0.0), vec3(0.0, -1.0, 0.0));
  return (sides.one + sides.other) * light.intensity / (2.0 * PI);
}

// Radiance of thick smoke at a place, cd/m². The light is the flame, or what glows of its wick.
vec3 scatteredRadiance(vec3 position, vec3 eye) {
  vec3 direct = scatteredFromFlame(light.intensity, light.position - position, eye - position);
  return SCATTERED * (direct * candleVisibility(position) + scatteredFromRoom(position) + NIGHT);
}
