// What a light looks like on the screen: adaptation to candlelight, tone, the screen's primaries, sRGB.
#include "lib/photometry.glsl"
#include "lib/srgb.glsl"
#include "lib/chromatic-adaptation.glsl"
#include "lib/tone-curve.glsl"

uniform float uToneMapped;  // 1: tone as film has it, 0: clipped
uniform mat3 uGamut;  // from linear Rec. 709 to the screen's primaries

// Light in that the eye is used to the colour of, where white is about 1.
vec3 toneAndEncode(vec3 light) {
  vec3 seen = graded(light);
  return encodeSrgb(uGamut * (uToneMapped > 0.5 ? tone(seen) : min(seen, 1.0)));
}

// Exposed light in.
vec3 shown(vec3 light) {
  return toneAndEncode(max(light, 0.0) * uAdaptation);
}
