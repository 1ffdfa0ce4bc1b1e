// Display transform: chromatic adaptation, tone curve, gamut, sRGB.
#include "lib/srgb.glsl"
#include "lib/chromatic-adaptation.glsl"
#include "lib/tone-curve.glsl"

uniform float uToneMapped;  // 1: tone curve, 0: clipped
uniform mat3 uGamut;  // from linear Rec. 709 to the screen's primaries

// From adapted and vivid light, where white is about 1, to display colour.
vec3 toneAndEncodeVivid(vec3 vivid) {
  return encodeSrgb(uGamut * (uToneMapped > 0.5 ? tone(vivid) : min(vivid, 1.0)));
}

// From adapted light to display colour.
vec3 toneAndEncode(vec3 light) {
  return toneAndEncodeVivid(applyVibrance(light));
}

// From exposed light to display colour.
vec3 displayColor(vec3 light) {
  return toneAndEncode(max(light, 0.0) * uAdaptation);
}
