// Reflectance of a surface as a whole.

// Specular reflectance of a dielectric for light from all around: fitted to src/render/opaque/environment-brdf.ts for
// roughness 0.3 to 1, within 0.003. The smoothest reflect 0.084: the mean of Fresnel's equations over a hemisphere.
float specularReflectance(float roughness) {
  return min(0.02 * exp(1.85 * (1.0 - roughness)), 0.084);
}

// Reflectance for light from all around, and gloss: what its alpha of GGX leaves of 1; negative of a dielectric, whose
// specular part is colourless.
vec4 reflectanceAndGloss(vec3 baseColor, float roughness, float metallic) {
  vec3 reflectance = mix(baseColor, vec3(1.0), specularReflectance(roughness) * (1.0 - metallic));
  float gloss = 1.0 - roughness * roughness;
  return vec4(reflectance, metallic > 0.0 ? metallic * gloss : -gloss);
}
