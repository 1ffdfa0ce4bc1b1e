// Soft shadow of the flame (PCSS): share of the flame that is visible from a point, past the room.
// Needs lib/flame-light.glsl, and SHADOW_BIAS (texels) defined.
// After Fernando 2005, "Percentage-Closer Soft Shadows"; here each tap is a point of the flame, so that the penumbra
// has the flame's width and height.
//
// A texel of the shadow cube is compared with the plane of the lit surface, where the ray through the texel's center
// meets it: a flat surface never shadows itself, however coarse the cube, and what lies on it does.
#include "lib/shadow-cube.glsl"

// A caster less far before the plane is the plane: metres; texels, since narrower joints are not resolved.
const float BIAS = 0.0015;
const float BIAS_TEXELS = float(SHADOW_BIAS);
// Facets of a rounded surface stand before each other's planes by this height, m. In grazing light that is more along the
// ray, up to the second; which those have, too, that face away where the rounded surface does not.
const float RELIEF = 0.0004;
const float MOST_RELIEF = 0.03;
// A plane seen edge on reaches no farther than this many times the distance of the point.
const float STEEPEST = 1.02;
// Least half-width of a penumbra, texels; and most of it, where texels are so large on the screen that their edges would
// be steps: as a share of their size in pixels.
const vec2 LEAST_PENUMBRA = vec2(0.4, 1.5);
const float STEP_SHARE = 0.35;
// Steps of the R2 sequence of low-discrepancy points.
// Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences".
const vec2 R2 = vec2(0.7548776662466927, 0.5698402909980532);
// Offset of the taps of one pixel from those of its neighbour: by 32 steps, so that the pixels of a small window
// together have the points of one sequence.
const vec2 SEED_STEP = fract(32.0 * R2);

// Taps of the filter in one iteration, unrolled.
const int TAPS_AT_ONCE = 4;

// A lit point and the flame, about the capture origin.
struct ShadowReceiver {
  vec3 position;  // m
  vec3 shift;     // of the flame since the capture, m
  vec3 normal;
  float offset;   // of the lit plane along its normal, m
  float distance; // m
  float bias;     // m
  vec3 across;    // of the flame, from the point: axes, and half-extents, m
  vec3 up;
  vec2 extent;
  float least;    // half-width of a penumbra at the point, m
};

// Taps on one face of the shadow cube, and the depth up to which each is a blocker.
struct ShadowTaps {
  vec2 corner;   // of the parallelogram that they fill, as shares of the tile
  vec2 right;    // its edges
  vec2 up;
  vec2 toPoint;  // from its middle to the lit point
  vec2 origin;   // of the tile, texels
  vec3 plane;    // depth in a texel: dot(plane, vec3(texel, 1))
  float farthest;
  float receiver; // depth of the lit point along the face's axis, m
};

// The taps at a share of the way from the flame to the point. All are on the face of their center.
ShadowTaps shadowTaps(ShadowReceiver r, float share, float tile) {
  float texels = 0.5 * tile / SHADOW_REACH;  // for a length of 1 on a face
  vec3 centerWorld = mix(r.shift, r.position, share);
  bvec2 axis = shadowAxis(centerWorld);
  vec3 center = onShadowFace(centerWorld, axis);
  vec3 across = onShadowFace(r.across, axis);
  vec3 up = onShadowFace(r.up, axis);
  vec3 normal = onShadowFace(r.normal, axis);
  vec2 onFace = center.xy / center.z;
  vec2 halfSize = max((1.0 - share) * r.extent, vec2(share * r.least));
  halfSize /= SHADOW_REACH * center.z;
  vec2 tileCenter = shadowTileCenter(axis, center.z, light.shadowSlot, tile);
  ShadowTaps taps;
  taps.right = (across.xy - onFace * across.z) * halfSize.x;
  taps.up = (up.xy - onFace * up.z) * halfSize.y;
  vec3 point = onShadowFace(r.position, axis);
  taps.toPoint = (point.xy / point.z - onFace) * (0.5 / SHADOW_REACH);
  taps.corner = 0.5 + onFace * (0.5 / SHADOW_REACH) - 0.5 * (taps.right + taps.up);
  taps.origin = tileCenter - 0.5 * tile;
  // The plane's inverse depth, nearer by the bias.
  float nearer = SHADOW_NEAR * r.distance / (r.distance - r.bias);
  float scale = -sign(center.z) * nearer / r.offset;
  taps.plane.xy = normal.xy * (scale / texels);
  taps.plane.z = 1.0 + scale * normal.z + dot(taps.plane.xy, 0.5 - tileCenter);
  float cosine = abs(center.z) * inversesqrt(dot(center, center));
  taps.receiver = r.distance * cosine;
  taps.farthest = 1.0 - SHADOW_NEAR / (cosine * (STEEPEST * r.distance - r.bias));
  return taps;
}

// Texel of a tap. `random`: from 0 to 1. `nearness`: how far from the middle to the lit point, from 0 to 1. `tile`: texels,
// less a hundredth, so that its end is within.
vec2 tapTexel(ShadowTaps taps, vec2 random, float nearness, float tile) {
  vec2 place = clamp(taps.corner + taps.right * random.x + taps.up * random.y + taps.toPoint * nearness, 0.0, 1.0);
  return floor(taps.origin + place * tile);
}

float planeDepth(ShadowTaps taps, vec2 texel) {
  return dot(taps.plane, vec3(texel, 1.0));
}

// `normal`: of the triangle. `footprint`: of a pixel, m.
ShadowReceiver shadowReceiver(vec3 position, vec3 normal, float footprint) {
  ShadowReceiver r;
  r.position = position - light.captureOrigin;
  r.shift = r.position + (light.position - position);
  r.normal = normal;
  r.distance = length(r.position);
  r.offset = dot(r.position, normal);
  r.offset = r.offset < 0.0 ? min(r.offset, -1e-5) : max(r.offset, 1e-5);
  float tile = shadowTileSize();
  float texels = 0.5 * tile / SHADOW_REACH;
  // A step of the stored depth is half as many metres to either side.
  float stepBias = r.distance * r.distance * (0.5 * SHADOW_STEP / SHADOW_NEAR);
  float relief = r.offset < 0.0 ? min(-RELIEF * r.distance / r.offset, MOST_RELIEF) : MOST_RELIEF;
  r.bias = max(BIAS, relief) + r.distance * (BIAS_TEXELS / texels) + stepBias;
  vec3 direction = r.position / r.distance;
  r.across = normalize(vec3(direction.z, 0.0, -direction.x) + vec3(1e-4, 0.0, 0.0));
  r.up = cross(direction, r.across);
  // The flame's half-extents, projected.
  r.extent = vec2(light.radius, mix(light.radius, light.halfHeight, abs(dot(r.up, light.along))));
  float texelSize = r.distance / texels;
  r.least = texelSize * clamp(STEP_SHARE * texelSize / footprint, LEAST_PENUMBRA.x, LEAST_PENUMBRA.y);
  return r;
}

// Shares of the flame that are visible from a point, and from one higher than it by `rise` along the normal (m).
// `normal`: of the triangle. `pixel`: seed of the taps' offset. `footprint`: of a pixel, m.
vec2 flameVisibility(int searchTaps, int filterTaps, vec3 position, vec3 normal, float rise, vec2 pixel, float footprint) {
  ShadowReceiver r = shadowReceiver(position, normal, footprint);
  float tile = shadowTileSize();
  vec2 seed = fract(SEED_STEP * (floor(pixel.x) + 7.0 * floor(pixel.y)));
  // Blocker search at a quarter of the way, where the penumbra is widest.
  ShadowTaps taps = shadowTaps(r, 0.25, tile);
  // The least penumbra's share of it, whose corners are searched first: what is thin and near the point is there.
  vec2 least = 1.0 / max(vec2(1.0), 3.0 * r.extent / r.least);
  int corners = searchTaps > 8 ? 4 : 0;
  vec2 place = seed;
  vec2 found = vec2(0.0);  // sum of the blockers' inverse depths, and their number
  for (int i = 0; i < searchTaps; i++) {
    // Denser towards the point, or they would miss what is thin and near it. The flame may be beside the capture origin.
    float spread = i < corners ? 0.0 : (float(i) + 0.5) / float(searchTaps);
    vec2 offset = i < corners ? least * (vec2(i & 1, i >> 1) - 0.5) : (fract(place) - 0.5) * spread;
    vec2 texel = tapTexel(taps, 0.5 + offset, 1.0 - spread, tile - 0.01);
    place += R2;
    float caster = shadowDepth(texel);
    if (caster < min(planeDepth(taps, texel), taps.farthest)) {
      found += vec2(1.0 - caster, 1.0);
    }
  }
  if (found.y == 0.0) return vec2(1.0);
  // Filter at the blockers' mean inverse distance, in which the penumbra's width is linear.
  float share = clamp(SHADOW_NEAR * found.y / (found.x * taps.receiver), 0.02, 0.98);
  // Computed anew, the flame's shift included: kept from above, it would need more registers than a Mali has. The term is
  // 0, which no compiler knows.
  r = shadowReceiver(position + min(found.y, 0.0), normal, footprint);
  taps = shadowTaps(r, share, tile);
  // Inverse depth of the higher plane, as a multiple of the plane's own.
  float higher = -abs(r.offset) / min(rise - abs(r.offset), -1e-4);
  place = seed;
  vec2 visible = vec2(0.0);
  for (int i = 0; i < filterTaps; i += TAPS_AT_ONCE) {
    for (int j = 0; j < TAPS_AT_ONCE; j++) {
      vec2 texel = tapTexel(taps, fract(place), 0.0, tile - 0.01);
      place += R2;
      float caster = shadowDepth(texel);
      float plane = planeDepth(taps, texel);
      visible.x += caster < min(plane, taps.farthest) ? 0.0 : 1.0;
      visible.y += caster < min(1.0 - (1.0 - plane) * higher, taps.farthest) ? 0.0 : 1.0;
    }
  }
  return visible / float(filterTaps);
}
