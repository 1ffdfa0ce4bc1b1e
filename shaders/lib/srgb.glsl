// Encoding of linear light as 8-bit sRGB.

// Highlight compression at constant hue: above a knee the brightest channel bends towards 1.
vec3 compressHighlights(vec3 linear) {
  const float KNEE = 0.7;
  float peak = max(max(linear.r, linear.g), linear.b);
  if (peak <= KNEE) return linear;
  float compressed = 1.0 - (1.0 - KNEE) * exp(-(peak - KNEE) / (1.0 - KNEE));
  return linear * (compressed / peak);
}

// IEC 61966-2-1. Its power is fitted by roots, to a tenth of an 8-bit step: they cost a software renderer far less.
vec3 encodeSrgb(vec3 linear) {
  vec3 low = linear * 12.92;
  vec3 curved = max(linear, vec3(0.0031308));
  vec3 root = sqrt(curved);
  vec3 high = 0.83355301 * root + 0.29826716 * sqrt(root) - 0.05524676 * curved - 0.07693432;
  return mix(high, low, lessThanEqual(linear, vec3(0.0031308)));
}

// From a uniform distribution in [0, 1) to a triangular one in (-1, 1).
vec3 triangular(vec3 uniformNoise) {
  vec3 centred = uniformNoise * 2.0 - 1.0;
  return sign(centred) * (1.0 - sqrt(1.0 - abs(centred)));
}

// Triangular dither of one 8-bit step, by a low-discrepancy lattice: every value occurs within a few pixels.
// Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences" (R2).
vec3 dither(vec2 pixel) {
  float place = dot(floor(pixel), vec2(0.754877666, 0.569840296));
  return triangular(fract(place + vec3(0.0, 1.0, 2.0) / 3.0)) / 255.0;
}

vec4 display(vec3 linear, vec2 pixel) {
  return vec4(encodeSrgb(compressHighlights(linear)) + dither(pixel), 1.0);
}
