#version 300 es
precision highp float;

const float USED = 1.0;
const float UNUSED = USED;
// Named by the next alone.
const vec2 ALSO_UNUSED = vec2(
  1.0,
  2.0
);

float unusedToo(
  float x
) {
#ifdef MODE
  if (x > 0.0) {
    return 0.0;
  }
#endif
  return x + ALSO_UNUSED.x;
}

float used(float x) { return x; }

out vec4 oColor;

void main() {
  oColor = vec4(used(USED));
}
