#version 300 es
// Radiosity of each surfel in the flame's direct light; MOON: in the moon's, and of the panes in the sky's.
// Out: lm/m²; gloss.
#include "lib/precision.glsl"
#include "lib/photometry.glsl"
#ifdef MOON
#include "lib/moon.glsl"
#else
#include "lib/flame-light.glsl"
#include "lib/pool-reflection.glsl"
#endif
#include "lib/surfels.glsl"

uniform sampler2D uSurfelReflectance;

out vec4 oRadiosity;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  Surfel surfel = surfelAt(texel, textureSize(uSurfelNormalDistance, 0).y);
  if (surfel.distance <= 0.0) {
    oRadiosity = vec4(0.0);
    return;
  }
  // A surfel receives all light in its solid angle, whatever its normal.
#ifdef MOON
  if (isPaneSurfel(texel, textureSize(uSurfelNormalDistance, 0).y)) {
    oRadiosity = vec4(vec3(PI * moon.sky), 0.0);
    return;
  }
  vec3 irradiance = vec3(surfel.solidAngle / surfel.area);
#else
  vec3 toLight = light.captureOrigin - surfel.position;
  float share = candleVisibility(surfel.position) * withPool(toLight, dot(toLight, toLight));
  vec3 irradiance = light.intensity * (surfel.solidAngle / surfel.area * share);
#endif
  vec4 reflectance = texelFetch(uSurfelReflectance, texel, 0);
  oRadiosity = vec4(reflectance.rgb * irradiance, reflectance.a);
}
