#version 300 es
// Vibrance of each hue.
// Out: adapted, vivid light for white-balanced light whose channels sum to 1.
#include "lib/precision.glsl"
#include "lib/chromatic-adaptation.glsl"
#include "lib/hue-lut.glsl"

out vec4 oVivid;

void main() {
  vec2 hue = floor(gl_FragCoord.xy) / (HUE_LUT_SIZE - 1.0);
  vec3 balanced = vec3(hue.x, max(1.0 - hue.x - hue.y, 0.0), hue.y);
  oVivid = vec4(applyVibrance(balanced * uWhite), 1.0);
}
