#version 300 es
// What gbuffer/gbuffer.frag finds out, for a picture among many: with half of the work.
// In:  root of the base colour, normal map; where something is metal or cut out, and the root is not
//      BAKED, occlusion/roughness/metallic map. What is UNTEXTURED, and so BAKED, has no maps.
// Out: root of the albedo, as the relief catches the light; how the surface lies, roughness, what it is.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/gbuffer.glsl"
#include "lib/normal-map-shading.glsl"

#if !UNTEXTURED
uniform sampler2D uGamma2Albedo;
uniform sampler2D uNormal;
#endif
uniform vec4 uBaseColor;   // its root
uniform float uWax;
uniform float uIsHeld;  // 1 or 0
uniform vec4 uSurface;     // roughness, metallic, normal scale, alpha below which nothing is
#if !BAKED
uniform sampler2D uOcclusionRoughness;
uniform float uOcclusionStrength;  // how much of the map's occlusion counts
#endif

in vec3 vNormalWorld;
in vec3 vToFlame;
in vec3 vUvAndOcclusion;

layout(location = 0) out vec4 oAlbedo;
layout(location = 1) out vec4 oSurface;

void main() {
#if UNTEXTURED
  const vec4 root = vec4(1.0);
  const vec3 packed = vec3(1.0);
  float occlusion = vUvAndOcclusion.z;
#else
  vec4 root = texture(uGamma2Albedo, vUvAndOcclusion.xy);
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
  float caught = 1.0;
  if (frame.normalMaps > 0.5) {
    vec3 L = vToFlame * inversesqrt(dot(vToFlame, vToFlame));
    L.z *= side;
#if UNTEXTURED
    caught = normalMapShading(L.z, L.z, 0.0);
#else
    vec2 slope = texture(uNormal, vUvAndOcclusion.xy).xy * 2.0 - 1.0;
    float up = sqrt(max(1.0 - dot(slope, slope), 0.0));
    caught = normalMapShading(L.z, dot(slope, L.xy) + up * L.z, uSurface.z);
#endif
  }
  oAlbedo = vec4(root.rgb * uBaseColor.rgb * sqrt(shadedAlbedoScale(occlusion, caught)), uIsHeld * HELD);
  float kind = uWax > 0.5 ? WAX : packed.b * uSurface.y * METAL;
  oSurface = encodeReducedSurface(vNormalWorld * side, packed.g * uSurface.x, kind);
}
