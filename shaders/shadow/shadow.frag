#version 300 es
// Shadow cube: depth alone.
#include "lib/precision.glsl"

void main() {}
