#version 300 es
// The resolved frame on the canvas, which has no alpha: samples can only be resolved to a target of their own format.
#include "lib/precision.glsl"

uniform sampler2D uFrame;

out vec4 oColor;

void main() {
  oColor = texelFetch(uFrame, ivec2(gl_FragCoord.xy), 0);
}
