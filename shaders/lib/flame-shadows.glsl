// Soft shadows of several flames, from an atlas of cubes, by SHADOW_TAPS samples. Needs lib/candle-flames.glsl.

#ifndef SHADOW_TAPS
#define SHADOW_TAPS 14
#endif

uniform sampler2D uShadowAtlas;  // distance from the flame, m; tiles of 3 x 2 faces
uniform vec2 uShadowTiles;       // across and down
uniform float uShadowFace;       // texels of a face's side

// Nearer than this nothing shadows its own candle, m, and as a share of the distance.
const float BIAS = 0.0012;
const float SLOPE = 0.012;
// Blockers are searched for as if they were so far from the flame, m.
const float NEAREST_BLOCKER = 0.02;
// Their origin above the root of the flame, m.
const float ORIGIN = 0.016;
const int SEARCH_TAPS = min(SHADOW_TAPS, 5);
const float GOLDEN_ANGLE = 2.39996;

// Face and uv of a direction, as src/render/lone-candle/flame-shadows.ts draws them.
float shadowDistance(int tile, vec3 direction) {
  vec3 size = abs(direction);
  float face;
  vec2 uv;
  if (size.x >= size.y && size.x >= size.z) {
    face = direction.x > 0.0 ? 0.0 : 1.0;
    uv = vec2(direction.x > 0.0 ? direction.z : -direction.z, direction.y) / size.x;
  } else if (size.y >= size.z) {
    face = direction.y > 0.0 ? 2.0 : 3.0;
    uv = vec2(direction.x, direction.y > 0.0 ? direction.z : -direction.z) / size.y;
  } else {
    face = direction.z > 0.0 ? 4.0 : 5.0;
    uv = vec2(direction.z > 0.0 ? -direction.x : direction.x, direction.y) / size.z;
  }
  float margin = 0.5 / uShadowFace;
  uv = clamp(0.5 + 0.5 * uv, margin, 1.0 - margin);
  float row = floor(float(tile) / uShadowTiles.x);
  vec2 place = vec2(float(tile) - row * uShadowTiles.x, row);
  vec2 corner = vec2(mod(face, 3.0), floor(face / 3.0));
  vec2 atlas = (place + (corner + uv) / vec2(3.0, 2.0)) / uShadowTiles;
  return textureLod(uShadowAtlas, atlas, 0.0).r;
}

// Visible share of a flame: percentage-closer soft shadows (Fernando 2005). The flame is higher than it is wide.
float flameVisibility(int i, vec3 position, vec3 normal) {
  int tile = int(flames.intensities[i].w);
  if (tile < 0) return 1.0;
  vec3 from = position + normal * BIAS - flames.roots[i].xyz - vec3(0.0, ORIGIN, 0.0);
  float way = length(from);
  vec3 direction = from / way;
  vec3 up = flames.alongs[i].xyz - direction * dot(flames.alongs[i].xyz, direction);
  float lying = length(up);
  vec3 across = normalize(cross(direction, vec3(direction.y, direction.z, -direction.x)));
  vec3 v = lying > 1e-3 ? up / lying : across;
  vec3 u = cross(direction, v);
  float radius = flames.alongs[i].w;
  vec2 size = vec2(radius, max(flames.centres[i].w * lying, radius));
  float near = way - BIAS - SLOPE * way;
  float reach = max(way - NEAREST_BLOCKER, 0.0) / NEAREST_BLOCKER;
  float blockers = 0.0;
  float sum = 0.0;
  for (int tap = 0; tap < SEARCH_TAPS; tap++) {
    float angle = GOLDEN_ANGLE * float(tap);
    vec2 offset = vec2(cos(angle), sin(angle)) * sqrt(float(tap) / float(SEARCH_TAPS - 1)) * min(size * reach, 0.3 * way);
    float found = shadowDistance(tile, from + u * offset.x + v * offset.y);
    if (found < near) {
      sum += found;
      blockers += 1.0;
    }
  }
  if (blockers == 0.0) return 1.0;
  float blocker = max(sum / blockers, 0.002);
  vec2 width = clamp(size * ((way - blocker) / blocker), vec2(0.004 * way), vec2(0.5 * way));
  float visible = 0.0;
  for (int tap = 0; tap < SHADOW_TAPS; tap++) {
    float angle = GOLDEN_ANGLE * float(tap);
    vec2 offset = vec2(cos(angle), sin(angle)) * sqrt((float(tap) + 0.5) / float(SHADOW_TAPS)) * width;
    float found = shadowDistance(tile, from + u * offset.x + v * offset.y);
    visible += smoothstep(-0.5, 0.5, (found - near) / (SLOPE * way));
  }
  return visible / float(SHADOW_TAPS);
}
