#version 300 es
// One layer of the table of the display's law.   Out: display colour, without noise.
#include "lib/precision.glsl"
#include "lib/display-transform.glsl"
#include "lib/tone-lut.glsl"

uniform float uLayer;

out vec4 oColor;

void main() {
  vec3 place = vec3(floor(gl_FragCoord.xy), uLayer) / (TONE_LUT_SIZE - 1.0);
  place *= place;
  oColor = vec4(toneAndEncode(place * place * TONE_LUT_MAX * uWhite), 1.0);
}
