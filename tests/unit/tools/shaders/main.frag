#version 300 es
// Two files that share a third.
#include "../tests/unit/tools/shaders/branch.glsl"
#include "../tests/unit/tools/shaders/twig.glsl"
/* A comment
   of two lines. */
out vec4 oColor;

const float MARKER_IN_MAIN = branch(1.0) * twig(2.0); // a product

#include "../tests/unit/tools/shaders/leaf.glsl"
void main() {
  oColor = vec4(branch(3.0)); // MARKER_AT_END
  oColor -= oColor.r - -branch(1.0);
}
