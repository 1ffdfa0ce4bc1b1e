// Soft shadows of several flames, from an atlas of cubes, by SHADOW_TAPS samples. Needs lib/candle-flames.glsl.
// As in lib/pcss.glsl a texel is compared with the plane of the lit surface, in the direction of the texel's center.

uniform sampler2D uShadowAtlas;  // distance from the flame, m; nearest texel of tiles of 3 x 2 faces
uniform vec2 uShadowTiles;       // across and down
uniform float uShadowFace;       // texels of a face's side

// A caster less far before the plane is the plane: m, and as a share of the distance.
const float BIAS = 0.0012;
const float SLOPE = 0.006;
// Facets of a rounded surface stand before each other's planes by this height, m; in grazing light by more along the ray,
// up to the second.
const float RELIEF = 0.0004;
const float MOST_RELIEF = 0.03;
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

// The texel of a direction, on the faces that src/render/lone-candle/flame-shadows.ts draws.
ShadowTexel shadowTexel(int tile, vec3 direction) {
  vec3 size = abs(direction);
  bool isX = size.x >= size.y && size.x >= size.z;
  bool isY = !isX && size.y >= size.z;
  // By the axes of the face: across, up, along.
  vec3 onFace = isX ? direction.zyx : isY ? direction.xzy : direction;
  float side = onFace.z > 0.0 ? 1.0 : -1.0;
  vec2 turned = isX ? vec2(side, 1.0) : isY ? vec2(1.0, side) : vec2(-side, 1.0);
  vec2 uv = 0.5 + 0.5 * turned * onFace.xy / abs(onFace.z);
  uv = (clamp(floor(uv * uShadowFace), 0.0, uShadowFace - 1.0) + 0.5) / uShadowFace;
  float face = (isX ? 0.0 : isY ? 2.0 : 4.0) + (side > 0.0 ? 0.0 : 1.0);
  float row = floor(float(tile) / uShadowTiles.x);
  vec2 place = vec2(float(tile) - row * uShadowTiles.x, row);
  vec2 corner = vec2(mod(face, 3.0), floor(face / 3.0));
  vec2 atlas = (place + (corner + uv) / vec2(3.0, 2.0)) / uShadowTiles;
  vec3 center = vec3(turned * (2.0 * uv - 1.0), side);
  center = isX ? center.zyx : isY ? center.xzy : center;
  return ShadowTexel(textureLod(uShadowAtlas, atlas, 0.0).r, center);
}

// Distance of the lit plane along a direction, m. `from`: a point of it, so far away as `way`.
float planeDistance(vec3 direction, vec3 from, vec3 facet, float way) {
  float times = dot(from, facet) / dot(direction, facet);
  float farthest = way * STEEPEST;
  return times > 0.0 ? min(times * length(direction), farthest) : farthest;
}

// Visible share of a flame: percentage-closer soft shadows (Fernando 2005). The flame is higher than it is wide.
// `facet`: normal of the triangle, on the side that is lit. `pixel`: by which the taps are turned.
float flameVisibility(int i, vec3 position, vec3 facet, vec2 pixel) {
  int tile = int(flames.intensities[i].w);
  if (tile < 0) return 1.0;
  vec4 root = flames.roots[i];
  vec3 from = position - root.xyz - vec3(0.0, root.w, 0.0);
  float way = length(from);
  vec3 direction = from / way;
  vec3 up = flames.alongs[i].xyz - direction * dot(flames.alongs[i].xyz, direction);
  float lying = length(up);
  vec3 across = normalize(cross(direction, vec3(direction.y, direction.z, -direction.x)));
  vec3 v = lying > 1e-3 ? up / lying : across;
  vec3 u = cross(direction, v);
  float radius = flames.alongs[i].w;
  vec2 size = vec2(radius, max(flames.centres[i].w * lying, radius));
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
    ShadowTexel texel = shadowTexel(tile, from + u * place.x + v * place.y);
    if (texel.distance < planeDistance(texel.direction, from, facet, way) - bias) {
      sum += texel.distance;
      blockers += 1.0;
    }
  }
  if (blockers == 0.0) return 1.0;
  float blocker = max(sum / blockers, 0.002);
  width = clamp(size * ((way - blocker) / blocker), vec2(2.0 * LEAST_PENUMBRA * way / uShadowFace), vec2(0.5 * way));
  float visible = 0.0;
  for (int tap = 0; tap < SHADOW_TAPS; tap++) {
    float angle = turn + GOLDEN_ANGLE * float(tap);
    vec2 place = vec2(cos(angle), sin(angle)) * sqrt((float(tap) + 0.5) / float(SHADOW_TAPS)) * width;
    ShadowTexel texel = shadowTexel(tile, from + u * place.x + v * place.y);
    visible += step(planeDistance(texel.direction, from, facet, way) - bias, texel.distance);
  }
  return visible / float(SHADOW_TAPS);
}
