// How much of the flame a point sees past what stands in the room.
// Needs lib/random.glsl, lib/flame-light.glsl.
// After Fernando 2005, "Percentage-Closer Soft Shadows"; here each tap is a point of the flame, so
// that the penumbra has the flame's own width and height.
//
// A texel of the cube is compared with the plane of what is lit, where the ray through the middle of that
// texel meets it: a flat surface never shades itself, however coarse the cube, and what lies on it does.

uniform samplerCube uShadow;  // distance from the vantage of what is nearest to it, m

// What is less before a plane than this is the plane: metres, a share of the distance, since that is known
// as half floats, and the width of so many texels, since joints narrower than that are not known at all.
const float BIAS = 0.0015;
const float BIAS_SLOPE = 0.001;
const float BIAS_TEXELS = 2.5;
// A plane seen edge on is taken to reach no further than this many times the distance of the point.
const float STEEPEST = 1.02;
// Half of the width over which a shadow's edge is blurred at least, in texels.
const float SOFTEST = 0.4;

// Evenly spread over a square from -1 to 1, whatever the count.
// Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences" (R2).
vec2 spread(int i, uvec2 turn) {
  uvec2 place = uvec2(uint(i) * 3242174889u, uint(i) * 2447445414u) + turn;
  return vec2(place >> 8) / 8388608.0 - 1.0;
}

// The middle of the texel of the cube that a direction falls on, with 1 along its face's axis.
vec3 texelAt(vec3 direction, float texels) {
  vec3 reach = abs(direction);
  float most = max(max(reach.x, reach.y), reach.z);
  vec3 onFace = direction / most;
  vec3 middle = (floor(onFace * texels) + 0.5) / texels;
  return mix(middle, onFace, vec3(greaterThanEqual(reach, vec3(most))));
}

// Distance from the vantage to a plane, the way that a texel lies, m. `away`: of the plane, along its normal.
float reachOfPlane(vec3 texel, vec3 facet, float away, float farthest) {
  float facing = dot(texel, facet);
  return facing * away > 0.0 ? min(length(texel) * away / facing, farthest) : farthest;
}

// `facet`: normal of the triangle, on the light's side. `pixel`: what the taps' turn depends on.
float flameVisibility(vec3 position, vec3 facet, vec2 pixel) {
  vec3 fromVantage = position - light.captureOrigin;
  float reach = length(fromVantage);
  float away = dot(fromVantage, facet);
  float farthest = reach * STEEPEST;
  float texels = 0.5 * float(textureSize(uShadow, 0).x);  // for a length of 1 on a face
  float bias = BIAS + reach * (BIAS_SLOPE + BIAS_TEXELS / texels);
  float softest = SOFTEST * reach / texels;
  vec3 direction = fromVantage / reach;
  vec3 across = normalize(vec3(direction.z, 0.0, -direction.x) + vec3(1e-4, 0.0, 0.0));
  vec3 up = cross(direction, across);
  // The flame, as it shows from here.
  vec2 size = vec2(light.radius, mix(light.radius, light.halfHeight, abs(dot(up, light.along))));
  // It has moved since the cube was made, by less than it is wide.
  vec3 shift = light.position - light.captureOrigin;
  uint chance = pcg(uint(pixel.x) + pcg(uint(pixel.y)));
  uvec2 turn = uvec2(chance, pcg(chance));
  float sum = 0.0;
  float found = 0.0;
  // Towards a blocker a quarter of the way: the widest part of the penumbra that matters.
  float share = 0.25;
  for (int i = 0; i < SHADOW_SEARCH; i++) {
    vec2 e = spread(i, turn) * max((1.0 - share) * size, share * softest);
    vec3 texel = texelAt(fromVantage * share + (1.0 - share) * shift + across * e.x + up * e.y, texels);
    float d = textureLod(uShadow, texel, 0.0).r;
    float isBlocker = step(d, reachOfPlane(texel, facet, away, farthest) - bias);
    sum += d * isBlocker;
    found += isBlocker;
  }
  if (found == 0.0) return 1.0;
  share = clamp(sum / (found * reach), 0.02, 0.98);
  float seen = 0.0;
  for (int i = 0; i < SHADOW_TAPS; i++) {
    vec2 e = spread(i, turn) * max((1.0 - share) * size, share * softest);
    vec3 texel = texelAt(fromVantage * share + (1.0 - share) * shift + across * e.x + up * e.y, texels);
    float d = textureLod(uShadow, texel, 0.0).r;
    seen += step(reachOfPlane(texel, facet, away, farthest) - bias, d);
  }
  return seen / float(SHADOW_TAPS);
}
