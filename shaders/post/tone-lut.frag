#version 300 es
// One layer of the tone LUT.   Out: display colour, without dither.
#include "lib/precision.glsl"
#include "lib/display-transform.glsl"
#include "lib/tone-lut.glsl"

uniform float uLayer;

out vec4 oColor;

void main() {
  vec3 root = vec3(floor(gl_FragCoord.xy), uLayer) / (TONE_LUT_SIZE - 1.0);
  root *= root;
  oColor = vec4(toneAndEncode(root * root * TONE_LUT_MAX * uWhite), 1.0);
}
