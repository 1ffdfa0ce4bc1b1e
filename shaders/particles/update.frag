#version 300 es
// For programs run only for what their vertex stage captures.
void main() {}
