#version 300 es
// Distance from a flame. CUTOUT: without what is cut out.   Out: m.
#include "lib/precision.glsl"
#ifdef CUTOUT
#include "lib/material.glsl"

in vec2 vUv;
#endif

uniform vec3 uFlame;  // m

in vec3 vPositionWorld;

out vec4 oDistance;

void main() {
#ifdef CUTOUT
  if (texture(uAlbedo, vUv).a * uBaseColor.a < uSurface.w) discard;
#endif
  oDistance = vec4(distance(vPositionWorld, uFlame), 0.0, 0.0, 1.0);
}
