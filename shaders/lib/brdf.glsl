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

// Alpha of the distribution widened by a light's extent. `tangent`: of the angle that the light's radius covers, seen from
// the surface. Karis 2013, "Real Shading in Unreal Engine 4".
float widenedAlpha(float alpha, float tangent) {
  return min(alpha + 0.5 * tangent, 1.0);
}
