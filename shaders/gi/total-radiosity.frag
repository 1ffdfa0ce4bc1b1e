#version 300 es
// Radiosity of each surfel in direct and indirect light, for reflections.
// Out: lm/m².
#include "lib/precision.glsl"
#include "lib/flame-light.glsl"
#include "lib/surfels.glsl"
#include "lib/irradiance-volume.glsl"

uniform sampler2D uSurfelReflectance;
uniform sampler2D uRadiosity;  // in direct light

// The volume is sampled this far in front of the surface, m.
const float NORMAL_OFFSET = 0.05;

out vec4 oRadiosity;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  Surfel surfel = surfelAt(texel, textureSize(uSurfelNormalDistance, 0).y);
  oRadiosity = vec4(0.0, 0.0, 0.0, 1.0);
  if (surfel.distance <= 0.0) return;
  vec3 position = surfel.position + surfel.normal * NORMAL_OFFSET;
  vec3 irradiance = irradianceAt(position, 0.0, surfel.normal, surfel.normal, surfel.normal).alongNormal;
  vec3 reflected = texelFetch(uSurfelReflectance, texel, 0).rgb * irradiance;
  // Of a surfel at a grazing angle, the area is limited and the flux is kept: its radiosity is not.
  float cosine = dot(surfel.normal, normalize(light.captureOrigin - surfel.position));
  vec3 direct = texelFetch(uRadiosity, texel, 0).rgb * (max(cosine, 0.0) / limitedCosine(cosine));
  oRadiosity.rgb = direct + reflected;
}
