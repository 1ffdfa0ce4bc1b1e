// From linear light to the 8 bits of an sRGB screen.
#include "lib/random.glsl"

// Colours beyond the screen's keep their hue: the brightest channel bends towards 1, the others
// keep their ratio to it. Below the knee nothing changes.
vec3 compressHighlights(vec3 linear) {
  const float KNEE = 0.7;
  float peak = max(max(linear.r, linear.g), linear.b);
  if (peak <= KNEE) return linear;
  float bent = 1.0 - (1.0 - KNEE) * exp(-(peak - KNEE) / (1.0 - KNEE));
  return linear * (bent / peak);
}

// IEC 61966-2-1.
vec3 encodeSrgb(vec3 linear) {
  vec3 low = linear * 12.92;
  vec3 high = 1.055 * pow(max(linear, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055;
  return mix(high, low, lessThanEqual(linear, vec3(0.0031308)));
}

// Noise of one 8-bit step, triangular, so that dark gradients show no bands.
vec3 dither(vec2 pixel) {
  uint hash = pcg(uint(pixel.x) + pcg(uint(pixel.y)));
  float r = unit(hash) + unit(pcg(hash)) - 1.0;
  float g = unit(pcg(hash + 1u)) + unit(pcg(hash + 2u)) - 1.0;
  float b = unit(pcg(hash + 3u)) + unit(pcg(hash + 4u)) - 1.0;
  return vec3(r, g, b) / 255.0;
}

vec4 display(vec3 linear, vec2 pixel) {
  return vec4(encodeSrgb(compressHighlights(linear)) + dither(pixel), 1.0);
}
