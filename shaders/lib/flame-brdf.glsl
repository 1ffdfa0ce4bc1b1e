// Specular reflection of a flame.
#include "lib/brdf.glsl"

// Least distance of the flame for the inverse square law, metres.
const float LEAST_DISTANCE = 0.01;
// A pane reflects next to nothing diffusely: the irradiance up to which its albedo counts, lx for 1 cd.
const float PANE_IRRADIANCE = 0.5;
// Length of a flame's luminous body beside that of the capsule that lights. Share by which the body is thinner above, and
// wider below, than an ellipsoid. Widening of the lobe, as a share of the flame's radius, by which the edge of its mirror
// image is as soft as its own. All by eye.
const float BODY_LENGTH = 1.5;
const float TAPERING = 0.3;
const float SOFTNESS = 0.1;

struct FlameSpecular {
  float lobe;  // D V / F, times the cosine to the representative point
  float SoH;   // cosine for Fresnel's term
};

// A flame as an ellipsoid, thinner above, by its representative point: the one nearest to the reflected ray. `toLight`:
// from the surface, m. `halfAxis`: from the middle to an end of the capsule, m.
// Karis 2013, "Real Shading in Unreal Engine 4".
FlameSpecular flameSpecular(vec3 toLight, vec3 halfAxis, float radius, vec3 normal, vec3 view, float NoV, float alpha) {
  halfAxis *= BODY_LENGTH;
  radius = max(radius, 1e-4);
  float axisSquared = max(dot(halfAxis, halfAxis), 1e-8);
  float radiusSquared = radius * radius;
  vec3 reflected = reflect(-view, normal);
  float steepness = dot(reflected, halfAxis);
  float along = dot(reflected, toLight);
  float offAxis = dot(toLight, halfAxis) - along * steepness;
  // Along the axis as far as the ray is, and no farther than the outline in that direction, by the ellipsoid's support.
  float offset = dot(toLight, toLight) - along * along;
  float outline = radiusSquared * offset + (1.0 - radiusSquared / axisSquared) * offAxis * offAxis;
  float most = min(abs(offAxis) * inversesqrt(max(outline, 1e-14)), 1.0);
  float climb = clamp(-offAxis / (axisSquared - steepness * steepness + radiusSquared), -most, most);
  vec3 representative = toLight + halfAxis * climb;
  vec3 aside = dot(reflected, representative) * reflected - representative;
  representative += aside * min(radius * sqrt(1.0 - climb * climb) * (1.0 - TAPERING * climb) / max(length(aside), 1e-5), 1.0);
  float squared = max(dot(representative, representative), LEAST_DISTANCE * LEAST_DISTANCE);
  alpha += SOFTNESS * radius * inversesqrt(squared);
  vec3 S = normalize(representative);
  vec3 H = normalize(S + view);
  float NoS = max(dot(normal, S), 0.0);
  float SoH = max(dot(S, H), 0.1);
  // The ellipsoid spreads the lobe's peak over a convex set of half vectors. That adds to the integral of GGX, which is 1,
  // the perimeter over 4 alpha, and the area over PI alpha squared, by Steiner's formula: the energy is divided by it.
  vec3 across = halfAxis - S * dot(S, halfAxis);
  float quarter = length(vec2(0.5 * length(cross(normal, across)) / SoH, 0.25 * PI * radius)) * inversesqrt(squared);
  float side = dot(across, across);
  float area = PI * radius * sqrt(side + radiusSquared * max(1.0 - side / axisSquared, 0.0));
  float lobe = distributionGgx(alpha, max(dot(normal, H), 0.0)) * visibilitySmith(alpha, NoV, NoS) * NoS;
  lobe /= 1.0 + (quarter + area / (4.0 * PI * squared * SoH * alpha)) / alpha;
  // A mirror image is no brighter than the flame.
  return FlameSpecular(min(lobe, dot(toLight, toLight) / area), SoH);
}
