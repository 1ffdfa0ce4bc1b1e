#version 300 es
// Reflectance at the hits of the probes' rays, at the mip level of a ray's footprint, less the self-occlusion of the
// normal map; and gloss.
#include "lib/precision.glsl"
#include "lib/reflectance.glsl"
#include "lib/normal-map.glsl"
#include "lib/relief.glsl"
#include "lib/material.glsl"

// Texels along an edge of the mip level that is read.
const float FOOTPRINT_TEXELS = 16.0;

in vec2 vUv;

out vec4 oReflectance;

void main() {
  float level = log2(max(float(textureSize(uAlbedo, 0).x) / FOOTPRINT_TEXELS, 1.0));
  vec3 baseColor = textureLod(uAlbedo, vUv, level).rgb * uBaseColor.rgb;
  baseColor *= meanSkyVisibility(uNormal, vUv, uSurface.z);
  vec2 roughnessMetallic = textureLod(uOcclusionRoughness, vUv, level).gb * uSurface.xy;
  oReflectance = reflectanceAndGloss(baseColor, roughnessMetallic.x, roughnessMetallic.y);
}
