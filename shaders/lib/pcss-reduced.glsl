// How much of the flame a point sees past what stands in the room.
// Needs lib/random.glsl, lib/flame-light.glsl.
// After Fernando 2005, "Percentage-Closer Soft Shadows"; here each tap is a point of the flame, so
// that the penumbra has the flame's own width and height.

uniform samplerCube uShadow;  // distance from the vantage of what is nearest to it, m

// A lit surface is this far from its own image in the cube, m, and per metre of distance.
const float BIAS = 0.012;
const float BIAS_SLOPE = 0.012;

// Vogel's spiral: evenly spread over a disc, whatever the count.
vec2 vogel(int i, int count, float turn) {
  float r = sqrt((float(i) + 0.5) / float(count));
  float angle = float(i) * 2.39996323 + turn;
  return r * vec2(cos(angle), sin(angle));
}

float flameVisibility(vec3 position, vec3 normal, vec2 pixel) {
  vec3 fromVantage = position - light.captureOrigin;
  float reach = length(fromVantage);
  vec3 direction = fromVantage / reach;
  float bias = BIAS + BIAS_SLOPE * reach;
  // Lifting the point off its surface lets grazing light past the cube's texels.
  vec3 lifted = fromVantage + normal * bias;
  float limit = length(lifted) - bias;
  vec3 across = normalize(vec3(direction.z, 0.0, -direction.x) + vec3(1e-4, 0.0, 0.0)) * light.radius;
  vec3 along = light.along * light.halfHeight;
  // The flame has moved since the cube was made, by less than it is wide.
  vec3 shift = light.position - light.captureOrigin;
  float turn = 6.2831853 * unit(pcg(uint(pixel.x) + pcg(uint(pixel.y))));
  float sum = 0.0;
  float found = 0.0;
  for (int i = 0; i < SHADOW_SEARCH; i++) {
    vec2 e = vogel(i, SHADOW_SEARCH, turn);
    // Towards a blocker a quarter of the way: the widest part of the penumbra that matters.
    float d = textureLod(uShadow, lifted * 0.25 + 0.75 * (shift + across * e.x + along * e.y), 0.0).r;
    float isBlocker = step(d, limit);
    sum += d * isBlocker;
    found += isBlocker;
  }
  if (found == 0.0) return 1.0;
  float share = clamp(sum / (found * length(lifted)), 0.02, 0.98);
  float seen = 0.0;
  for (int i = 0; i < SHADOW_TAPS; i++) {
    vec2 e = vogel(i, SHADOW_TAPS, turn);
    vec3 through = lifted * share + (1.0 - share) * (shift + across * e.x + along * e.y);
    seen += step(limit, textureLod(uShadow, through, 0.0).r);
  }
  return seen / float(SHADOW_TAPS);
}
