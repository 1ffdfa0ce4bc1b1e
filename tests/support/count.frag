#version 300 es
// How often a pixel is drawn: one more in red.
#include "lib/precision.glsl"

out vec4 oCount;

void main() {
  oCount = vec4(1.0, 0.0, 0.0, 0.0);
}
