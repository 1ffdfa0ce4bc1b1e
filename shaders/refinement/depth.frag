#version 300 es
// Depth prepass of the refined image: depth alone.
#include "lib/precision.glsl"

void main() {}
