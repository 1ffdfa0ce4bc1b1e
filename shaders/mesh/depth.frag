#version 300 es
// Depth of a mesh alone. CUTOUT: without what is cut out; COLORED: by the vertices' opacity, too, and at the texture's own level.
// Out: depth; black, where colours are not masked.
#include "lib/precision.glsl"
#ifdef CUTOUT
#include "lib/mesh-fragment.glsl"
#endif

out vec4 oColor;

void main() {
#ifdef CUTOUT
#ifdef COLORED
  float opacity = texture(uAlbedo, vUv).a * vColor.a;
#else
  float opacity = texture(uAlbedo, vUv, LOD_BIAS).a;
#endif
  if (opacity * uBaseColor.a < uSurface.w) discard;
#endif
  oColor = vec4(0.0);
}
