#version 300 es
// Bilinear upscaling to the canvas.   In and out: display colour.
#include "lib/precision.glsl"

uniform sampler2D uSource;

in vec2 vUv;

out vec4 oColor;

void main() {
  oColor = vec4(texture(uSource, vUv).rgb, 1.0);
}
