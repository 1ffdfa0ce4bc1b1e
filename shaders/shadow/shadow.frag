#version 300 es
// Shadow cube, or the moon's map: depth alone. CUTOUT: without what is cut out.
#include "lib/precision.glsl"
#ifdef CUTOUT
#include "lib/material.glsl"

in vec2 vUv;
in float vOpacity;

// Finer than a texel of the map asks for: means of the opacity close small holes, or open all.
const float LOD_BIAS = -1.5;
#endif

void main() {
#ifdef CUTOUT
  if (texture(uAlbedo, vUv, LOD_BIAS).a * uBaseColor.a * vOpacity < uSurface.w) discard;
#endif
}
