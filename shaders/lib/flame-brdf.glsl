// Specular reflection of the flame.
// Needs lib/flame-light.glsl.
#include "lib/brdf.glsl"

// Least distance of the flame for the inverse square law, metres.
const float LEAST_DISTANCE = 0.01;
// A pane reflects next to nothing diffusely: the irradiance up to which its albedo counts, lx for 1 cd.
const float PANE_IRRADIANCE = 0.5;

struct FlameSpecular {
  float lobe;  // D V / F, times the cosine to the representative point
  float SoH;   // cosine for Fresnel's term
};

// The flame as a capsule light, by its representative point: the one nearest to the reflected ray. `toLight`: from the
// surface, m.
// Karis 2013, "Real Shading in Unreal Engine 4".
FlameSpecular flameSpecular(vec3 toLight, vec3 normal, vec3 view, float NoV, float alpha) {
  vec3 reflected = reflect(-view, normal);
  float along = dot(reflected, toLight);
  float steepness = dot(reflected, light.along);
  float offAxis = dot(toLight, light.along) - along * steepness;
  float climb = clamp(-offAxis / max(1.0 - steepness * steepness, 1e-3), -light.halfHeight, light.halfHeight);
  vec3 representative = toLight + light.along * climb;
  vec3 S = normalize(representative);
  vec3 H = normalize(S + view);
  float tangent = light.radius / max(length(representative), LEAST_DISTANCE);
  float NoS = max(dot(normal, S), 0.0);
  float lobe = widenedLobe(alpha, tangent, dot(normal, H), NoV, NoS);
  return FlameSpecular(lobe * NoS, max(dot(S, H), 0.0));
}
