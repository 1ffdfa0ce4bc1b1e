#version 300 es
// Bounding hull of the flame: a six-sided tube along its spine, within which rays are marched.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/flame-body.glsl"

const int SIDES = 6;

// Vertex of a ring around a bounding sphere; the first and the last ring are points and close the tube.
vec3 hullVertex(int ring, int side) {
  int i = clamp(ring - 1, 0, SPHERES - 1);
  vec4 sphere = flame.spheres[i];
  sphere.w += MARGIN;
  // Both directions are steadied by the whole spine's: rings that turned against their neighbours, or crossed them where the
  // flame is shorter than wide, would show parts of the hull twice.
  vec3 lean = normalize(flame.tip);
  vec3 along = flame.spheres[min(i + 1, SPHERES - 1)].xyz - flame.spheres[max(i - 1, 0)].xyz;
  along = normalize(along + lean * sphere.w);
  if (ring == 0) return sphere.xyz - along * sphere.w * 1.1;
  if (ring == SPHERES + 1) return sphere.xyz + along * sphere.w * 1.1;
  vec3 aside = vec3(lean.z + 1e-5, 0.0, -lean.x);
  vec3 across = normalize(aside - along * dot(aside, along));
  float angle = 6.2831853 * float(side) / float(SIDES);
  // Wider than the sphere, so that the flat sides contain it: HULL of src/render/volumetric/volumetric-stage.ts.
  float width = sphere.w * 1.2;
  return sphere.xyz + (across * cos(angle) + cross(along, across) * sin(angle)) * width;
}

void main() {
  // Two triangles for each side between two rings.
  int quad = gl_VertexID / 6;
  int point = int[6](0, 1, 2, 2, 1, 3)[gl_VertexID % 6];
  int ring = quad / SIDES + (point >> 1);
  int side = quad % SIDES + (point & 1);
  gl_Position = frame.clipFromWorld * vec4(flame.base + hullVertex(ring, side), 1.0);
}
