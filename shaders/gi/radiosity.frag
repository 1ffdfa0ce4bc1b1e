#version 300 es
// Radiosity of each surfel in the flame's direct light.
// Out: lm/m².
#include "lib/precision.glsl"
#include "lib/photometry.glsl"
#include "lib/flame-light.glsl"
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
  vec3 irradiance = light.intensity * (surfel.solidAngle / surfel.area * candleVisibility(surfel.position));
  oRadiosity = vec4(texelFetch(uSurfelReflectance, texel, 0).rgb * irradiance, 1.0);
}
