#version 300 es
// Depth of a mesh alone. CUTOUT: without what is cut out.
// Out: depth; black, where colours are not masked.
#include "lib/precision.glsl"
#ifdef CUTOUT
#include "lib/mesh-fragment.glsl"
#endif

out vec4 oColor;

void main() {
#ifdef CUTOUT
  if (texture(uAlbedo, vUv, LOD_BIAS).a * uBaseColor.a < uSurface.w) discard;
#endif
  oColor = vec4(0.0);
}
