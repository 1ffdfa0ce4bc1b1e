// Light as an eye sees it that is used to the candle's colour.
// Needs lib/photometry.glsl.

uniform vec3 uAdaptation;  // factor of each channel (von Kries 1902)
uniform vec3 uWhite;       // what candlelight turns to; luma 1
uniform float uVibrance;  // how much further than in nature a faint hue is from white; 0: no further

// Under one warm lamp wood, stone and cloth are nearly of one hue, which the eye tells apart and a
// small bright picture in a dark frame does not. So faint hues are moved away from white, in logarithms,
// the more so the fainter. Strong ones stay, up to a limit: what is much bluer than the candle, as its
// own base, would be a blue that no eye sees there. Luminance is kept.
vec3 graded(vec3 light) {
  const float FAINT = 0.95;
  const float STRONG = 1.4;
  const float BEYOND = 0.8;
  float luminance = luma(light);
  if (luminance <= 0.0) return vec3(0.0);
  vec3 hue = log(max(light / luminance, 1e-4) / uWhite);
  float distance_ = max(length(hue), 1e-4);
  float shown = distance_ * (1.0 + uVibrance * exp(-distance_ * distance_ / (FAINT * FAINT)));
  if (shown > STRONG) shown = STRONG + BEYOND * (1.0 - exp((STRONG - shown) / BEYOND));
  vec3 vivid = uWhite * exp(hue * (shown / distance_));
  return vivid * (luminance / luma(vivid));
}

vec3 adapted(vec3 radiance) {
  return graded(max(radiance, 0.0) * uAdaptation);
}
