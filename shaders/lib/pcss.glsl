// Soft shadow of the flame (PCSS): share of the flame that a point sees past the room.
// Needs lib/random.glsl, lib/flame-light.glsl; defines SHADOW_SEARCH and SHADOW_TAPS (taps), SHADOW_BIAS (texels).
// After Fernando 2005, "Percentage-Closer Soft Shadows"; here each tap is a point of the flame, so that the penumbra
// has the flame's width and height.
//
// A texel of the shadow cube is compared with the plane of the lit surface, where the ray through the texel's center
// meets it: a flat surface never shadows itself, however coarse the cube, and what lies on it does.

uniform samplerCube uShadow;  // distance from the capture origin to the nearest caster, m

// A caster less far before the plane is the plane: metres; a share of the distance, which is a half float; texels,
// since narrower joints are not resolved.
const float BIAS = 0.0015;
const float BIAS_SLOPE = 0.001;
const float BIAS_TEXELS = float(SHADOW_BIAS);
// A plane seen edge on reaches no farther than this many times the distance of the point.
const float STEEPEST = 1.02;
// Least half-width of a penumbra, texels.
const float LEAST_PENUMBRA = 0.4;

// Low-discrepancy points on a square from -1 to 1.
// Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences" (R2).
vec2 r2Point(int i, uvec2 offset) {
  uvec2 place = uvec2(uint(i) * 3242174889u, uint(i) * 2447445414u) + offset;
  return vec2(place >> 8) / 8388608.0 - 1.0;
}

// Center of the cube's texel in a direction, with 1 along its face's axis.
vec3 texelCenter(vec3 direction, float texels) {
  vec3 magnitude = abs(direction);
  float largest = max(max(magnitude.x, magnitude.y), magnitude.z);
  vec3 onFace = direction / largest;
  vec3 center = (floor(onFace * texels) + 0.5) / texels;
  return mix(center, onFace, vec3(greaterThanEqual(magnitude, vec3(largest))));
}

// Distance from the capture origin to a plane through a texel's center, m. `offset`: of the plane along its normal.
float planeDistance(vec3 texel, vec3 normal, float offset, float farthest) {
  float cosine = dot(texel, normal);
  return cosine * offset > 0.0 ? min(length(texel) * offset / cosine, farthest) : farthest;
}

// `normal`: of the triangle, on the light's side. `pixel`: seed of the taps' offset.
float flameVisibility(vec3 position, vec3 normal, vec2 pixel) {
  vec3 fromOrigin = position - light.captureOrigin;
  float distance_ = length(fromOrigin);
  float offset = dot(fromOrigin, normal);
  float farthest = distance_ * STEEPEST;
  float texels = 0.5 * float(textureSize(uShadow, 0).x);  // for a length of 1 on a face
  float bias = BIAS + distance_ * (BIAS_SLOPE + BIAS_TEXELS / texels);
  float leastPenumbra = LEAST_PENUMBRA * distance_ / texels;
  vec3 direction = fromOrigin / distance_;
  vec3 across = normalize(vec3(direction.z, 0.0, -direction.x) + vec3(1e-4, 0.0, 0.0));
  vec3 up = cross(direction, across);
  // The flame's half-extents, projected.
  vec2 extent = vec2(light.radius, mix(light.radius, light.halfHeight, abs(dot(up, light.along))));
  // It has moved since the capture by less than its width.
  vec3 shift = light.position - light.captureOrigin;
  uint hash = pcg(uint(pixel.x) + pcg(uint(pixel.y)));
  uvec2 seed = uvec2(hash, pcg(hash));
  // Blocker search at a quarter of the way, where the penumbra is widest.
  float share = 0.25;
  float sum = 0.0;
  float blockers = 0.0;
  for (int i = 0; i < SHADOW_SEARCH; i++) {
    vec2 e = r2Point(i, seed) * max((1.0 - share) * extent, share * leastPenumbra);
    vec3 texel = texelCenter(fromOrigin * share + (1.0 - share) * shift + across * e.x + up * e.y, texels);
    float caster = textureLod(uShadow, texel, 0.0).r;
    float isBlocker = step(caster, planeDistance(texel, normal, offset, farthest) - bias);
    sum += caster * isBlocker;
    blockers += isBlocker;
  }
  if (blockers == 0.0) return 1.0;
  // Filter at the blockers' mean distance.
  share = clamp(sum / (blockers * distance_), 0.02, 0.98);
  float visible = 0.0;
  for (int i = 0; i < SHADOW_TAPS; i++) {
    vec2 e = r2Point(i, seed) * max((1.0 - share) * extent, share * leastPenumbra);
    vec3 texel = texelCenter(fromOrigin * share + (1.0 - share) * shift + across * e.x + up * e.y, texels);
    float caster = textureLod(uShadow, texel, 0.0).r;
    visible += step(planeDistance(texel, normal, offset, farthest) - bias, caster);
  }
  return visible / float(SHADOW_TAPS);
}
