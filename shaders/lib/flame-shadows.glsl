// Soft shadow of a flame whose casters may be nearer to it than it is high: SHADOW_TAPS samples, each on the face of the
// shadow cube that it meets. Needs lib/flame-light.glsl.
// As in lib/pcss.glsl a texel is compared with the plane of the lit surface, in the direction of the texel's center.
#include "lib/shadow-cube.glsl"

// A caster less far before the plane is the plane: m, as a share of the distance, and as one of a tap's from the middle,
// since in a concave edge the other face stands before the plane.
const float BIAS = 0.0003;
const float SLOPE = 0.003;
const float CONE = 0.25;
// Facets of a rounded surface stand before each other's planes by this height, m; in grazing light by more along the ray,
// up to the second.
const float RELIEF = 0.0001;
const float MOST_RELIEF = 0.006;
// A plane seen edge on reaches no farther than this many times the distance of the point.
const float STEEPEST = 1.1;
// Blockers are searched for as if they were so far from the flame, m.
const float NEAREST_BLOCKER = 0.02;
// Least half-width of a penumbra, texels.
const float LEAST_PENUMBRA = 0.8;
const int SEARCH_TAPS = min(SHADOW_TAPS, 16);
const float GOLDEN_ANGLE = 2.39996;

struct ShadowTexel {
  float distance;  // m
  vec3 direction;  // of its center
};

ShadowTexel shadowTexel(vec3 direction) {
  bvec2 axis = shadowAxis(direction);
  vec3 along = onShadowFace(direction, axis);
  float tile = shadowTileSize();
  float texels = 0.5 * tile / SHADOW_REACH;
  vec2 middle = shadowTileCenter(axis, along.z, light.shadowSlot, tile);
  vec2 texel = floor(middle + along.xy / along.z * texels);
  vec3 center = vec3((texel + 0.5 - middle) / texels, 1.0) * sign(along.z);
  float distance = SHADOW_NEAR * length(center) / max(1.0 - shadowDepth(texel), SHADOW_STEP);
  return ShadowTexel(distance, axis.x ? center.zxy : axis.y ? center.yzx : center);
}

// Distance of the lit plane along a direction, m. `from`: a point of it, so far away as `way`.
float planeDistance(vec3 direction, vec3 from, vec3 facet, float way) {
  float times = dot(from, facet) / dot(direction, facet);
  float farthest = way * STEEPEST;
  return times > 0.0 ? min(times * length(direction), farthest) : farthest;
}

// Visible share of the flame: percentage-closer soft shadows (Fernando 2005). The flame is higher than it is wide.
// `facet`: normal of the triangle, on the side that is lit. `pixel`: by which the taps are turned.
float flameVisibility(vec3 position, vec3 facet, vec2 pixel) {
  if (light.shadowSlot < 0.0) return 1.0;
  vec3 from = position - light.captureOrigin;
  float way = length(from);
  vec3 direction = from / way;
  vec3 up = light.along - direction * dot(light.along, direction);
  float lying = length(up);
  vec3 across = normalize(cross(direction, vec3(direction.y, direction.z, -direction.x)));
  vec3 v = lying > 1e-3 ? up / lying : across;
  vec3 u = cross(direction, v);
  vec2 size = vec2(light.radius, max(light.halfHeight * lying, light.radius));
  float bias = BIAS + SLOPE * way + min(RELIEF * way / max(-dot(from, facet), 1e-5), MOST_RELIEF);
  float reach = max(way - NEAREST_BLOCKER, 0.0) / NEAREST_BLOCKER;
  // Interleaved gradient noise: Jimenez 2014, "Next Generation Post Processing in Call of Duty: Advanced Warfare".
  float turn = 6.2831853 * fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
  vec2 width = min(size * reach, vec2(0.3 * way));
  float blockers = 0.0;
  float sum = 0.0;
  for (int tap = 0; tap < SEARCH_TAPS; tap++) {
    float angle = turn + GOLDEN_ANGLE * float(tap);
    vec2 place = vec2(cos(angle), sin(angle)) * sqrt((float(tap) + 0.5) / float(SEARCH_TAPS)) * width;
    ShadowTexel texel = shadowTexel(from + u * place.x + v * place.y);
    if (texel.distance < planeDistance(texel.direction, from, facet, way) - bias - CONE * length(place)) {
      sum += texel.distance;
      blockers += 1.0;
    }
  }
  if (blockers == 0.0) return 1.0;
  float blocker = max(sum / blockers, 0.002);
  float leastPenumbra = LEAST_PENUMBRA * way * 2.0 * SHADOW_REACH / shadowTileSize();
  width = clamp(size * ((way - blocker) / blocker), vec2(leastPenumbra), vec2(0.5 * way));
  float visible = 0.0;
  for (int tap = 0; tap < SHADOW_TAPS; tap++) {
    float angle = turn + GOLDEN_ANGLE * float(tap);
    vec2 place = vec2(cos(angle), sin(angle)) * sqrt((float(tap) + 0.5) / float(SHADOW_TAPS)) * width;
    ShadowTexel texel = shadowTexel(from + u * place.x + v * place.y);
    visible += step(planeDistance(texel.direction, from, facet, way) - bias - CONE * length(place), texel.distance);
  }
  return visible / float(SHADOW_TAPS);
}
