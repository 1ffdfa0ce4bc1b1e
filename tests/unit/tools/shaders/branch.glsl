// Needs the leaf.
#include "../tests/unit/tools/shaders/leaf.glsl"

float branch(float x) { return leaf(x) + 1.0; /* MARKER_IN_BRANCH */ }
