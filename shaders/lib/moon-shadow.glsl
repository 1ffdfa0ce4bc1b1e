// Soft shadow of the moon (PCSS): share of its disc that is visible from a point.
// Needs lib/random.glsl, lib/moon.glsl; defines SHADOW_SEARCH and SHADOW_TAPS (taps).
// After Fernando 2005, "Percentage-Closer Soft Shadows".

uniform highp sampler2D uMoonMap;  // depth of the nearest caster, a share of the map's depth

const float DISC_TURN = 2.399963;
// Least radius of the filter, texels.
const float LEAST_RADIUS = 0.8;
// The same in footprints of what is lit: a narrower edge would be stair-steps.
const float FOOTPRINT = 0.75;
// Largest change of the plane's depth for each metre across the light.
const float STEEPEST_PLANE = 12.0;

// A point of a disc, evenly spread. Vogel 1979, "A better way to construct the sunflower head".
vec2 onDisc(float i, float count, float turn) {
  float angle = i * DISC_TURN + turn;
  return sqrt((i + 0.5) / count) * vec2(cos(angle), sin(angle));
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
  // The widest penumbra: of a caster at the map's beginning.
  float reach = MOON_TANGENT * place.z;
  float texel = width / texels.x;
  float sum = 0.0;
  float blockers = 0.0;
  // Software renderers execute both sides of an `if`, but skip a loop that no pixel enters.
  bool isInside = isOnMap(place.xy) && isInBeam(position);
  int count = isInside ? SHADOW_SEARCH : 0;
  for (int i = 0; i < count; i++) {
    vec2 offset = onDisc(float(i), float(SHADOW_SEARCH), turn) * max(reach, max(2.0 * texel, footprint));
    vec2 at = clamp(place.xy + offset / vec2(width, height), vec2(0.0), vec2(0.9999));
    float caster = texelFetch(uMoonMap, ivec2(at * texels), 0).r * moon.depth;
    if (caster < place.z + dot(slope, offset) - MOON_BIAS) {
      sum += caster;
      blockers++;
    }
  }
  float radius = blockers > 0.0 ? MOON_TANGENT * (place.z - sum / blockers) : 0.0;
  radius = max(radius, max(LEAST_RADIUS * texel, FOOTPRINT * footprint));
  float lit = 0.0;
  count = blockers > 0.0 ? SHADOW_TAPS : 0;
  for (int i = 0; i < count; i++) {
    vec2 offset = onDisc(float(i), float(SHADOW_TAPS), turn) * radius;
    vec2 at = clamp(place.xy + offset / vec2(width, height), vec2(0.0), vec2(0.9999));
    float caster = texelFetch(uMoonMap, ivec2(at * texels), 0).r * moon.depth;
    lit += caster < place.z + dot(slope, offset) - MOON_BIAS ? 0.0 : 1.0;
  }
  float share = blockers > 0.0 ? lit / float(SHADOW_TAPS) : 1.0;
  return isInside ? share : 0.0;
}
