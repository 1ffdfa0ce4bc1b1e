#version 300 es
// Normal where those of a triangle's vertices cancel, and their tangents; and its length.
#include "lib/precision.glsl"
#include "lib/normal-map.glsl"

out vec4 oFound;

void main() {
  vec3 zero = 0.0 * gl_FragCoord.xyz;
  vec3 normal = perturbedNormal(vec2(0.7, 0.4), zero, vec4(zero, 1.0), 1.0);
  oFound = vec4(directionOf(zero).y, length(normal), 0.0, 1.0);
}
