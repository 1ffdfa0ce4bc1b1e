#include "../tests/unit/tools/shaders/leaf.glsl"

float twig(float x) { return leaf(x) * 2.0; /* MARKER_IN_TWIG */ }
