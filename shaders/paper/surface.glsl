// Material maps and shading normal of a surface in the paper's lighting.
// Needs lib/frame.glsl, paper/light.glsl.
#include "lib/normal-map.glsl"

uniform sampler2D uAlbedo;
uniform sampler2D uNormal;
uniform sampler2D uOcclusionRoughness;
uniform vec4 uBaseColor;
uniform float uOcclusionStrength;  // of the map, 0 to 1

in vec3 vPositionWorld;
in vec3 vNormalWorld;
in vec4 vTangentWorld;
in vec2 vUv;

vec3 surfaceNormal() {
  if (light.flatShading > 0.5) return facetNormal(vPositionWorld);
  if (frame.normalMaps > 0.5) return perturbedNormal(uNormal, vUv, vNormalWorld, vTangentWorld);
  return normalize(vNormalWorld);
}
