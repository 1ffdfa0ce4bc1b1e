#version 300 es
// Advances particles without drawing them: ticks between two frames.
#include "particles/kernel.glsl"

void main() {
  moveParticle();
}
