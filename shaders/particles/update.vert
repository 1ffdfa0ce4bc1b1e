#version 300 es
// Moves particles that nobody sees: the ticks that a picture missed.
#include "particles/kernel.glsl"

void main() {
  moveParticle();
}
