// Antialiasing of an image with one sample a pixel: a pixel at an edge is mixed with two of its neighbours along the edge,
// whose direction comes from the four nearest pixels. After Lottes 2009, "FXAA".

// Distance of the taps along the edge, pixels: each falls between two of them.
const float TAP_DISTANCE = 1.5;
// Their share at a full edge.
const float TAPS_SHARE = 0.8;

// Across and up. `differences` from the left, right, lower and upper neighbour.
vec2 edgeGradient(vec4 differences) {
  return vec2(abs(differences.x) + abs(differences.y), abs(differences.z) + abs(differences.w));
}

// From a pixel to a tap, pixels; the other one is opposite. The edge is perpendicular to the gradient.
vec2 tapAlongEdge(vec4 differences, vec2 gradient) {
  float side = (differences.y - differences.x) * (differences.w - differences.z) > 0.0 ? -1.0 : 1.0;
  return TAP_DISTANCE * normalize(vec2(gradient.y, side * gradient.x));
}

// `range`: of differences, from where an edge begins to where it is full.
float shareOfTaps(vec2 gradient, vec2 range) {
  return TAPS_SHARE * smoothstep(range.x, range.y, max(gradient.x, gradient.y));
}
