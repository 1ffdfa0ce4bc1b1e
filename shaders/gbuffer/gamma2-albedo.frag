#version 300 es
// A base colour as paint keeps it, so that who reads it has no curve to undo: software takes four times as
// long for a texel of sRGB as for one of plain bytes.
// In:  base colour (sRGB), occlusion/roughness map.
// Out: its root; in alpha opacity, or BAKED: roughness, and crevices are painted on.
#include "lib/precision.glsl"
#if BAKED
#include "lib/gbuffer.glsl"
#include "lib/normal-map-shading.glsl"

uniform sampler2D uOcclusionRoughness;
uniform float uOcclusionStrength;  // how much of the map's occlusion counts
#endif

uniform sampler2D uAlbedo;

in vec2 vUv;

out vec4 oRoot;

void main() {
  vec4 albedo = texture(uAlbedo, vUv);
#if BAKED
  vec2 packed = texture(uOcclusionRoughness, vUv).rg;
  float share = shadedAlbedoScale(mix(1.0, packed.r, uOcclusionStrength), 1.0) * ALBEDO_SCALE;
  oRoot = vec4(sqrt(albedo.rgb * share), packed.g);
#else
  oRoot = vec4(sqrt(albedo.rgb), albedo.a);
#endif
}
