#version 300 es
// G-buffer: the visible surfaces without their light.
// In:  base colour (sRGB), normal, occlusion/roughness/metallic maps.
// Out: gamma-2 albedo times normal-map shading; octahedral normal, roughness, material.
//      REDUCED: encoded as by gbuffer/gbuffer-reduced.frag, for which this stands in until its textures are made.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/octahedral.glsl"
#include "lib/normal-map.glsl"
#include "lib/gbuffer.glsl"
#include "lib/normal-map-shading.glsl"
#include "lib/mesh-fragment.glsl"

uniform float uMaterial;   // wax or glass; 0: what the maps say
#if REDUCED
uniform float uIsHeld;  // 1 or 0
#endif
uniform vec3 uCaptureOrigin;   // of the light, m

layout(location = 0) out vec4 oAlbedo;
layout(location = 1) out vec4 oSurface;

void main() {
  vec4 baseColor = texture(uAlbedo, vUv) * uBaseColor;
#if ALPHA_TESTED
  if (baseColor.a < uSurface.w) discard;
#endif
  vec3 packed = texture(uOcclusionRoughness, vUv).rgb;
  vec3 normal = directionOf(vNormalWorld) * (gl_FrontFacing ? 1.0 : -1.0);
  float shading = 1.0;
  if (frame.normalMaps > 0.5 && !isWax(uMaterial)) {
    vec3 mapped = perturbedNormal(texture(uNormal, vUv).xy, normal, vTangentWorld, uSurface.z);
    vec3 L = normalize(uCaptureOrigin - vPositionWorld);
    shading = normalMapShading(dot(normal, L), dot(mapped, L));
  }
  float occlusion = mix(1.0, packed.r, uOcclusionStrength) * vColor.r;
  oAlbedo = vec4(sqrt(min(baseColor.rgb * shadedAlbedoScale(occlusion, shading), 1.0)), 0.0);
  float material = uMaterial > 0.0 ? uMaterial : packed.b * uSurface.y * METAL;
#if REDUCED
  oAlbedo.a = uIsHeld * HELD;
  oSurface = encodeReducedSurface(normal, packed.g * uSurface.x, material);
#else
  oSurface = vec4(octahedralEncode(normal), clamp(packed.g * uSurface.x, 0.03, 1.0), material);
#endif
}
