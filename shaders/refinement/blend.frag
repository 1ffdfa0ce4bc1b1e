#version 300 es
// The refined image in the frame's light.
// In:  display colours in two lights.   Out: display colour.
#include "lib/precision.glsl"

uniform sampler2D uDimmer;
uniform sampler2D uBrighter;

flat in float vShare;

out vec4 oColor;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  oColor = mix(texelFetch(uDimmer, texel, 0), texelFetch(uBrighter, texel, 0), vShare);
}
