// What a light looks like on the screen: adaptation to candlelight, tone, the screen's primaries, sRGB.
#include "lib/photometry.glsl"
#include "lib/display.glsl"
#include "lib/adaptation.glsl"
#include "lib/tone.glsl"

uniform float uTone;  // 1: tone as film has it, 0: clipped
uniform mat3 uGamut;  // from linear Rec. 709 to the screen's primaries

// Exposed light in, where white is about 1.
vec3 shown(vec3 light) {
  vec3 seen = adapted(light);
  return encodeSrgb(uGamut * (uTone > 0.5 ? tone(seen) : min(seen, 1.0)));
}
