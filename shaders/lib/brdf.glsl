// Reflection of light by a rough surface.
#include "lib/photometry.glsl"

// Walter, Marschner, Li and Torrance 2007, "Microfacet Models for Refraction through Rough
// Surfaces", equation (33).
float distributionGgx(float alpha, float NoH) {
  float a2 = alpha * alpha;
  float d = NoH * NoH * (a2 - 1.0) + 1.0;
  return a2 / (PI * d * d);
}

// Heitz 2014, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", divided by
// 4 NoL NoV.
float visibilitySmith(float alpha, float NoV, float NoL) {
  float a2 = alpha * alpha;
  float view = NoL * sqrt(NoV * NoV * (1.0 - a2) + a2);
  float light = NoV * sqrt(NoL * NoL * (1.0 - a2) + a2);
  return 0.5 / max(view + light, 1e-5);
}

// Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering".
vec3 fresnelSchlick(vec3 f0, float LoH) {
  float m = 1.0 - LoH;
  float m2 = m * m;
  return f0 + (1.0 - f0) * (m2 * m2 * m);
}

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
