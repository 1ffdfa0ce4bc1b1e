// The material of a mesh at a pixel of forward shading.
// Needs lib/frame.glsl, lib/normal-map.glsl, lib/environment-brdf.glsl.
#include "lib/mesh-fragment.glsl"

// Share of the probes' light that surfaces nearer than their spacing occlude, by the baked occlusion. Fitted to a path
// tracer's indirect light in the cabin's views (`npm run reference`).
const float NEAR_OCCLUSION = 0.5;

uniform sampler2D uNormalMapVisibility;  // by level of detail: mesh/normal-map-visibility.frag

struct Material {
  vec3 baseColor;
  float occlusion;
  float roughness;
  float metallic;
};

// What the light is reflected by.
struct Shading {
  vec3 surface;  // normals: the mesh's, and the normal map's
  vec3 normal;
  vec3 view;
  float NoV;
  float alpha;
  vec3 f0;
  vec2 minified;  // visibility of a minified normal map: of light from all around, and of direct light
};

// CUTOUT: discards what is cut out; depth is tested late in a program that discards.
void cutOut() {
#ifdef CUTOUT
  if (texture(uAlbedo, vUv, LOD_BIAS).a * uBaseColor.a < uSurface.w) discard;
#endif
}

vec3 occlusionRoughnessMetallicHere() {
  vec3 packed = texture(uOcclusionRoughness, vUv, LOD_BIAS).rgb;
  float occlusion = mix(1.0, packed.r, uOcclusionStrength) * vColor.r;
  return vec3(occlusion, clamp(packed.g * uSurface.x, 0.03, 1.0), packed.b * uSurface.y);
}

Material materialHere(vec3 occlusionRoughnessMetallic) {
  vec3 baseColor = texture(uAlbedo, vUv, LOD_BIAS).rgb * uBaseColor.rgb;
  return Material(baseColor, occlusionRoughnessMetallic.x, occlusionRoughnessMetallic.y, occlusionRoughnessMetallic.z);
}

vec3 shadingNormal(vec3 surface) {
  if (frame.normalMaps < 0.5) return surface;
  return perturbedNormal(texture(uNormal, vUv).xy, surface, vTangentWorld, uSurface.z);
}

vec2 minifiedVisibility() {
  if (frame.normalMaps < 0.5) return vec2(1.0);
  vec2 texels = vec2(textureSize(uNormal, 0));
  float texelsInPixel = abs(determinant(mat2(dFdx(vUv) * texels, dFdy(vUv) * texels)));
  float level = 0.5 * log2(max(texelsInPixel, 1.0));
  float levels = float(textureSize(uNormalMapVisibility, 0).x);
  return textureLod(uNormalMapVisibility, vec2((level + 0.5) / levels, 0.5), 0.0).rg;
}

Shading shadingOf(Material material, vec3 surface, vec3 normal) {
  vec3 view = normalize(frame.eyePosition - vPositionWorld);
  float NoV = max(abs(dot(normal, view)), 1e-3);
  vec2 minified = minifiedVisibility();
  float alpha = specularAntialiasing(material.roughness * material.roughness, normal);
  vec3 f0 = mix(vec3(0.04), material.baseColor, material.metallic);
  return Shading(surface, normal, view, NoV, alpha, f0, minified);
}
