#version 300 es
// What a linear function of places becomes between the corners of a cell, at many places.   Out: 1 and how far off.
#include "lib/precision.glsl"
#include "lib/random.glsl"
#include "lib/tetrahedron.glsl"

out vec4 oRadiance;

void main() {
  uint seed = pcg(uint(gl_FragCoord.x) + pcg(uint(gl_FragCoord.y)));
  vec3 share = vec3(unit(seed), unit(pcg(seed)), unit(pcg(pcg(seed))));
  Tetrahedron tetrahedron = tetrahedronAt(share);
  vec3 mixed = vec3(0.0);
  for (int corner = 0; corner < 4; corner++) {
    mixed += tetrahedron.weights[corner] * tetrahedronCorner(tetrahedron, corner, share);
  }
  vec3 apart = abs(mixed - share);
  oRadiance = vec4(1.0 + max(max(apart.x, apart.y), apart.z), 0.0, 0.0, 1.0);
}
