#version 300 es
// What each patch that the flame sees sends back of its light.
// Out: radiosity, lm/m².
#include "lib/precision.glsl"
#include "lib/photometry.glsl"
#include "lib/flame-light.glsl"
#include "lib/surfels.glsl"

uniform sampler2D uSurfelAlbedo;

out vec4 oRadiosity;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  Surfel surfel = surfelAt(texel, textureSize(uSurfelNormalDistance, 0).y);
  if (surfel.distance <= 0.0) {
    oRadiosity = vec4(0.0);
    return;
  }
  // All of the light in the patch's solid angle falls on it, however it is turned.
  vec3 irradiance = light.intensity * (surfel.solidAngle / surfel.area * candleVisibility(surfel.position));
  oRadiosity = vec4(reflected(texelFetch(uSurfelAlbedo, texel, 0).rgb) * irradiance, 1.0);
}
