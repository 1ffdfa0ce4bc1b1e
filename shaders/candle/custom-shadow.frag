#version 300 es
// Distance from a flame. COLORED: without what is cut out, by the vertices' opacity, too.   Out: m.
#include "lib/precision.glsl"
#ifdef COLORED
#include "lib/material.glsl"

in vec2 vUv;
in float vOpacity;
#endif

uniform vec3 uFlame;  // m

in vec3 vPositionWorld;

out vec4 oDistance;

void main() {
#ifdef COLORED
  if (texture(uAlbedo, vUv).a * uBaseColor.a * vOpacity < uSurface.w) discard;
#endif
  oDistance = vec4(distance(vPositionWorld, uFlame), 0.0, 0.0, 1.0);
}
