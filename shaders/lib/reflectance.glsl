// Reflectance of a surface as a whole.

// Reflectance for light from all around, and how much of that is mirrored rather than scattered: 0, or of a metal what its
// alpha of GGX leaves of 1. The colourless specular part of a dielectric is its mean over the hemisphere: fitted to
// src/render/opaque/environment-brdf.ts for roughness 0.3 to 1, within 0.003.
vec4 reflectanceAndGloss(vec3 baseColor, float roughness, float metallic) {
  vec3 reflectance = mix(baseColor, vec3(1.0), 0.02 * exp(1.85 * (1.0 - roughness)) * (1.0 - metallic));
  return vec4(reflectance, metallic * (1.0 - roughness * roughness));
}
