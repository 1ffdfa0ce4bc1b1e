// Reflection of light from all around, and by normals that differ within a pixel.

// Directional albedo of a rough mirror, and compensation for the energy that single scattering loses between facets.
struct EnvironmentReflection {
  vec3 share;
  vec3 boost;
};

// Turquin 2019, "Practical Multiple Scattering Compensation for Microfacet Models".
// The table: src/render/opaque/environment-brdf.ts.
EnvironmentReflection environmentReflection(sampler2D table, vec3 f0, float roughness, float NoV) {
  float size = float(textureSize(table, 0).x);
  vec2 known = textureLod(table, (vec2(NoV, roughness) * (size - 1.0) + 0.5) / size, 0.0).rg;
  vec3 boost = 1.0 + f0 * (1.0 / known.x - 1.0);
  return EnvironmentReflection((f0 * (known.x - known.y) + known.y) * boost, boost);
}

// Tokuyoshi and Kaplanyan 2019, "Improved Geometric Specular Antialiasing": normals that differ within a
// pixel are roughness there. Alpha before and after.
float specularAntialiasing(float alpha, vec3 normal) {
  vec3 across = dFdx(normal);
  vec3 down = dFdy(normal);
  float variance = 0.25 * (dot(across, across) + dot(down, down));
  return sqrt(min(alpha * alpha + min(2.0 * variance, 0.18), 1.0));
}
