// The flame's body in the room. It leans by shear: every height keeps its round section.

// The table reaches this far beyond the luminous edge, in radii.
const float BODY_REACH = 1.25;

layout(std140) uniform Flame {
  vec3 base;     // m
  float radius;  // m
  vec3 tip;      // m
  float steps;
} flame;
