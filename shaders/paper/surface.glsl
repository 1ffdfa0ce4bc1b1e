// Material maps and shading normal of a surface in the paper's lighting.
// With FACETS or NORMAL_MAPS defined, normals are the triangles' or the map's, else the vertices'; with CUTOUT, what is cut
// out is discarded.
#include "lib/normal-map.glsl"
#include "lib/material.glsl"

uniform float uCodesEdges;  // 1 or 0

in vec3 vPositionWorld;
in vec3 vNormalWorld;
in vec4 vTangentWorld;
in vec2 vUv;

// Alpha: 1, or a code of the surface by its normal, from `least` to half more, in which antialiasing finds edges.
float edgeCode(float least) {
  float code = least + 0.25 + 0.25 * dot(vNormalWorld, vec3(0.4, 0.8, 0.2));
  return mix(1.0, code, uCodesEdges);
}

vec3 albedoHere() {
  vec4 baseColor = texture(uAlbedo, vUv) * uBaseColor;
#if CUTOUT
  if (baseColor.a < uSurface.w) discard;
#endif
  return baseColor.rgb;
}

vec3 surfaceNormal() {
  vec3 normal = directionOf(vNormalWorld) * (gl_FrontFacing ? 1.0 : -1.0);
#if defined(FACETS)
  return facetNormal(vPositionWorld);
#elif defined(NORMAL_MAPS)
  return perturbedNormal(texture(uNormal, vUv).xy, normal, vTangentWorld, uSurface.z);
#else
  return normal;
#endif
}
