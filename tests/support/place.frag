#version 300 es
// Places as colours, m: 8 m more, so that none is negative. Alpha: 0.00001 on the left, 1 on the right. CUTOUT: without what is cut out.
#include "lib/precision.glsl"

centroid in vec3 vPositionWorld;
#ifdef CUTOUT
centroid in vec2 vUv;
uniform sampler2D uAlbedo;
#endif

out vec4 oColor;

void main() {
#ifdef CUTOUT
  if (texture(uAlbedo, vUv).a < 0.5) discard;
#endif
  oColor = vec4(vPositionWorld + 8.0, max(step(0.0, vPositionWorld.x), 1e-5));
}
