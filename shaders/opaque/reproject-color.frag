#version 300 es
// Reprojection of the history buffer -> current frame.
// In:  display colour, motion.   Out: display colour.
#include "lib/precision.glsl"

uniform sampler2D uHistory;
uniform sampler2D uMotion;  // nearest texel

in vec2 vUv;

out vec4 oColor;

void main() {
  oColor = vec4(texture(uHistory, vUv + texture(uMotion, vUv).xy).rgb, 1.0);
}
