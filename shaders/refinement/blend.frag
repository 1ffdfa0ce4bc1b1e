#version 300 es
// The refined image in the frame's light.
// In:  display colours in two lights.   Out: display colour.
#include "lib/precision.glsl"

uniform sampler2D uDimmer;
uniform sampler2D uBrighter;

in vec2 vUv;
flat in float vShare;

out vec4 oColor;

void main() {
  oColor = mix(texture(uDimmer, vUv), texture(uBrighter, vUv), vShare);
}
