// Directional reflection of bounced light's first bounce: metals mirror the flame.
#include "lib/brdf.glsl"

// Least alpha of GGX, so that lobes are no narrower than samples are apart: groups of surfels, six along a face of their
// cube at every tier. Kaplanyan and Dachsbacher 2013, "Path Space Regularization for Holistic and Robust Light Transport".
const float LEAST_LOBE_ALPHA = 0.26;

// Share of the reflected light by direction, 1/sr: `gloss` as in lib/reflectance.glsl; of a scattering surface 1 / PI.
float glossyLobe(float gloss, vec3 normal, vec3 toLight, vec3 toEye) {
  if (gloss <= 0.0) return 1.0 / PI;
  float alpha = max(1.0 - gloss, LEAST_LOBE_ALPHA);
  float NoL = max(dot(normal, toLight), 1e-3);
  float NoV = max(dot(normal, toEye), 1e-3);
  float NoH = max(dot(normal, normalize(toLight + toEye)), 0.0);
  return distributionGgx(alpha, NoH) * visibilitySmith(alpha, NoV, NoL);
}
