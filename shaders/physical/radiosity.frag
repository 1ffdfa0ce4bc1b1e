#version 300 es
// What each patch sends back: its base colour times all the light that falls on it.
// Out: radiosity, lm/m².
#include "lib/precision.glsl"
#include "lib/photometry.glsl"
#include "physical/light.glsl"
#include "physical/volume.glsl"
#include "physical/surfels.glsl"

uniform sampler2D uPatchColor;

out vec4 oRadiosity;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  Surfel surfel = surfelAt(texel, textureSize(uNormalDistance, 0).y);
  if (surfel.distance <= 0.0) {
    oRadiosity = vec4(0.0);
    return;
  }
  vec3 toLight = light.position - surfel.position;
  float distanceSquared = max(dot(toLight, toLight), 1e-4);  // the flame is 1 cm wide
  float NoL = max(dot(surfel.normal, toLight) * inversesqrt(distanceSquared), 0.0);
  vec3 irradiance = light.intensity * (NoL / distanceSquared * pastCandle(surfel.position));
  irradiance += irradianceFrom(surroundingsAt(surfel.position + surfel.normal * 0.05), surfel.normal);
  oRadiosity = vec4(texelFetch(uPatchColor, texel, 0).rgb * irradiance, 1.0);
}
