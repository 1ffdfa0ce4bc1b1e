#version 300 es
// Empty stage for transform feedback without rasterisation.
void main() {}
