#version 300 es
// The hull of the flame: a six-sided tube along its spine, within which rays are marched.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/flame-body.glsl"

out vec3 vPosition;  // m, from the foot of the flame

const int SIDES = 6;

// Rings around the balls; a first and a last of no width close the tube.
vec3 corner(int ring, int side) {
  int ball = clamp(ring - 1, 0, BALLS - 1);
  vec4 here = flame.balls[ball];
  vec3 along = normalize(flame.balls[min(ball + 1, BALLS - 1)].xyz - flame.balls[max(ball - 1, 0)].xyz);
  if (ring == 0) return here.xyz - along * here.w * 1.1;
  if (ring == BALLS + 1) return here.xyz + along * here.w * 1.1;
  vec3 across = normalize(vec3(along.y, -along.x, 0.0) + vec3(1e-5, 0.0, 0.0));
  float angle = 6.2831853 * float(side) / float(SIDES);
  // A ring at the ends is pulled back so that the tube stays convex there.
  float width = here.w * 1.2;
  return here.xyz + (across * cos(angle) + cross(along, across) * sin(angle)) * width;
}

void main() {
  // Two triangles for each side of each stretch between rings.
  int quad = gl_VertexID / 6;
  int point = int[6](0, 1, 2, 2, 1, 3)[gl_VertexID - quad * 6];
  int ring = quad / SIDES + (point >> 1);
  int side = quad - (quad / SIDES) * SIDES + (point & 1);
  vPosition = corner(ring, side);
  gl_Position = frame.clipFromWorld * vec4(flame.base + vPosition, 1.0);
}
