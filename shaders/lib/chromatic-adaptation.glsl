// Chromatic adaptation to candlelight, vibrance, and rod vision.
#include "lib/photometry.glsl"

uniform vec3 uAdaptation;  // gain of each channel (von Kries 1902)
uniform vec3 uWhite;       // adapted colour of candlelight, luma 1
uniform float uVibrance;   // gain of the saturation of faint hues; 0: none
uniform float uRods;       // share of rod vision, which has no hue

// Rod vision looks bluish, as rods share nerves with cones. Cao, Pokorny, Smith and Zele 2008, "Rod contributions to
// color perception: Linear with rod contrast"; Kirk and O'Brien 2011, "Perceptually Based Tone Mapping for Low-Light
// Conditions".
const vec3 ROD_COLOR = vec3(0.76, 1.0, 1.42);

// Raises the saturation of faint hues, at constant luminance. Wood, stone and cloth in candlelight are nearly of one
// hue, which an adapted eye tells apart, but not on a small bright display in a dark room. Saturation is the
// logarithmic distance from white; strong hues keep theirs up to a limit, beyond which the blue base of the flame
// would lie.
vec3 applyVibrance(vec3 light) {
  const float FAINT = 0.95;
  const float STRONG = 1.4;
  const float BEYOND = 0.8;
  float luminance = luma(light);
  if (luminance <= 0.0) return vec3(0.0);
  vec3 hue = log(max(light / luminance, 1e-4) / uWhite);
  float saturation = max(length(hue), 1e-4);
  float raised = saturation * (1.0 + uVibrance * exp(-saturation * saturation / (FAINT * FAINT)));
  if (raised > STRONG) raised = STRONG + BEYOND * (1.0 - exp((STRONG - raised) / BEYOND));
  vec3 vivid = uWhite * exp(hue * (raised / saturation));
  return mix(vivid * (luminance / luma(vivid)), ROD_COLOR * luminance, uRods);
}

vec3 adaptRadiance(vec3 radiance) {
  return applyVibrance(max(radiance, 0.0) * uAdaptation);
}
