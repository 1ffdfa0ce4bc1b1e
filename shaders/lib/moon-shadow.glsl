// Soft shadow of the moon (PCSS): share of its disc that is visible from a point.
// Needs lib/moon.glsl, and SHADOW_SEARCH and SHADOW_TAPS (taps) defined.
// After Fernando 2005, "Percentage-Closer Soft Shadows".
#include "lib/random.glsl"

uniform highp sampler2D uMoonMap;  // depth of the nearest caster, a share of the map's depth

// Least radius of the filter, texels.
const float LEAST_RADIUS = 0.8;
// The same in footprints of what is lit: a narrower edge would be stair-steps.
const float FOOTPRINT = 0.75;
// Largest change of the plane's depth for each metre across the light.
const float STEEPEST_PLANE = 12.0;

// Points of a disc, evenly spread: each is turned by the golden angle from the last.
// Vogel 1979, "A better way to construct the sunflower head".
const mat2 GOLDEN_TURN = mat2(-0.7373687, 0.6754905, -0.6754905, -0.7373687);

float discRadius(int i, int count) {
  return sqrt((float(i) + 0.5) / float(count));
}

// `normal`: of the surface, on the light's side. `pixel`: seed of the taps' turn. `footprint`: of a texel, m.
float moonVisibility(vec3 position, vec3 normal, vec2 pixel, float footprint) {
  vec3 place = onMoonMap(position);
  float width = length(moon.across);
  float height = length(moon.up);
  vec2 texels = vec2(textureSize(uMoonMap, 0));
  // Depth of the lit plane along both edges of the map, m for each metre.
  float facing = min(dot(normal, moon.direction), -1.0 / STEEPEST_PLANE);
  vec2 slope = -vec2(dot(normal, moon.across) / width, dot(normal, moon.up) / height) / facing;
  slope = clamp(slope, -STEEPEST_PLANE, STEEPEST_PLANE);
  float turn = 6.2831853 * unit(pcg(uint(pixel.x) + pcg(uint(pixel.y))));
  vec2 begin = vec2(cos(turn), sin(turn));
  // The widest penumbra: of a caster at the map's beginning.
  float reach = MOON_TANGENT * place.z;
  float texel = width / texels.x;
  float sum = 0.0;
  float blockers = 0.0;
  // Software renderers execute both sides of an `if`, but skip a loop that no pixel enters.
  bool isInside = isOnMap(place.xy) && isInBeam(position);
  float radius = max(reach, max(2.0 * texel, footprint));
  vec2 direction = begin;
  int count = isInside ? SHADOW_SEARCH : 0;
  for (int i = 0; i < count; i++) {
    vec2 offset = direction * (discRadius(i, SHADOW_SEARCH) * radius);
    direction = GOLDEN_TURN * direction;
    vec2 at = clamp(place.xy + offset / vec2(width, height), vec2(0.0), vec2(0.9999));
    float caster = texelFetch(uMoonMap, ivec2(at * texels), 0).r * moon.depth;
    if (caster < place.z + dot(slope, offset) - MOON_BIAS) {
      sum += caster;
      blockers++;
    }
  }
  radius = blockers > 0.0 ? MOON_TANGENT * (place.z - sum / blockers) : 0.0;
  radius = max(radius, max(LEAST_RADIUS * texel, FOOTPRINT * footprint));
  float lit = 0.0;
  direction = begin;
  count = blockers > 0.0 ? SHADOW_TAPS : 0;
  for (int i = 0; i < count; i++) {
    vec2 offset = direction * (discRadius(i, SHADOW_TAPS) * radius);
    direction = GOLDEN_TURN * direction;
    vec2 at = clamp(place.xy + offset / vec2(width, height), vec2(0.0), vec2(0.9999));
    float caster = texelFetch(uMoonMap, ivec2(at * texels), 0).r * moon.depth;
    lit += caster < place.z + dot(slope, offset) - MOON_BIAS ? 0.0 : 1.0;
  }
  float share = blockers > 0.0 ? lit / float(SHADOW_TAPS) : 1.0;
  return isInside ? share : 0.0;
}
