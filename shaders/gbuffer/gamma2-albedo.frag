#version 300 es
// Gamma-2 albedo: software decodes a texel of plain bytes in a quarter of the time of an sRGB one.
// In:  base colour (sRGB), occlusion/roughness map.
// Out: square root of the albedo; in alpha the opacity, or BAKED: the roughness, with the occlusion in the albedo.
#include "lib/precision.glsl"
#include "lib/material.glsl"
#if BAKED
#include "lib/gbuffer.glsl"
#include "lib/normal-map-shading.glsl"
#endif

in vec2 vUv;

out vec4 oAlbedo;

void main() {
  vec4 albedo = texture(uAlbedo, vUv);
#if BAKED
  vec2 packed = texture(uOcclusionRoughness, vUv).rg;
  float scale = shadedAlbedoScale(mix(1.0, packed.r, uOcclusionStrength), 1.0) * ALBEDO_SCALE;
  oAlbedo = vec4(sqrt(albedo.rgb * scale), packed.g);
#else
  oAlbedo = vec4(sqrt(albedo.rgb), albedo.a);
#endif
}
