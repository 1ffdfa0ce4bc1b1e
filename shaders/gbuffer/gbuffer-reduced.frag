#version 300 es
// Reduced G-buffer, for frames in motion: what gbuffer/gbuffer.frag writes at half of the cost.
// In:  gamma-2 albedo and base colour, normal map; unless occlusion and roughness are BAKED into the albedo, their map. What is
//      UNTEXTURED, and so BAKED, has no maps.
// Out: gamma-2 albedo times normal-map shading; normal, roughness, material.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/gbuffer.glsl"
#include "lib/normal-map-shading.glsl"
#include "lib/material.glsl"
#if !UNTEXTURED
#include "lib/normal-map.glsl"
#endif

uniform sampler2D uGamma2Albedo;
uniform float uMaterial;  // wax or glass; 0: what the maps say
uniform float uIsHeld;    // 1 or 0

in vec3 vNormalWorld;
in vec3 vToLight;
in vec3 vUvAndOcclusion;

layout(location = 0) out vec4 oAlbedo;
layout(location = 1) out vec4 oSurface;

// Of the albedo: accumulated frames show the pixels of the canvas, two of which are a texel's edge.
// Normals, of which one texel is read, would dot joints.
const float LOD_BIAS = -1.0;

void main() {
#if UNTEXTURED
  const vec4 root = vec4(1.0);
  const vec3 packed = vec3(1.0);
  float occlusion = vUvAndOcclusion.z;
#else
  vec4 root = texture(uGamma2Albedo, vUvAndOcclusion.xy, LOD_BIAS);
#if BAKED
  vec3 packed = vec3(1.0, root.a, 0.0);
  float occlusion = vUvAndOcclusion.z;
#else
#if ALPHA_TESTED
  if (root.a * uBaseColor.a < uSurface.w) discard;
#endif
  vec3 packed = texture(uOcclusionRoughness, vUvAndOcclusion.xy).rgb;
  float occlusion = mix(1.0, packed.r, uOcclusionStrength) * vUvAndOcclusion.z;
#endif
#endif
  float side = gl_FrontFacing ? 1.0 : -1.0;
  float shading = 1.0;
#if !UNTEXTURED
  if (frame.normalMaps > 0.5 && !isWax(uMaterial)) {
    vec3 L = vToLight * (side * inversesqrt(dot(vToLight, vToLight)));
    vec3 normal = tangentNormal(texture(uNormal, vUvAndOcclusion.xy).xy, uSurface.z);
    shading = normalMapShading(L.z, dot(normal, L));
  }
#endif
  oAlbedo = vec4(root.rgb * uBaseColor.rgb * sqrt(shadedAlbedoScale(occlusion, shading)), uIsHeld * HELD);
  float material = uMaterial > 0.0 ? uMaterial : packed.b * uSurface.y * METAL;
  oSurface = encodeReducedSurface(vNormalWorld * side, packed.g * uSurface.x, material);
}
