#version 300 es
// The room by the paper's lighting: Lambert and Blinn-Phong in tangent space, attenuated.
// In:  albedo (sRGB), normal, and occlusion/roughness maps.   Out: display colour; alpha may tell surfaces apart.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "paper/light.glsl"
#include "paper/surface.glsl"
#include "lib/srgb.glsl"

const float SPECULAR = 0.5;

out vec4 oColor;

void main() {
  vec3 albedo = albedoHere();
  vec2 occlusionRoughness = texture(uOcclusionRoughness, vUv).rg;
  vec3 normal = surfaceNormal();
  vec3 toLight = light.position - vPositionWorld;
  float distance = length(toLight);
  vec3 lightDirection = toLight / max(distance, 1e-3);  // the flame is over 1 mm thick
  vec3 halfway = normalize(lightDirection + normalize(frame.eyePosition - vPositionWorld));
  float diffuse = max(dot(normal, lightDirection), 0.0) * mix(1.0, occlusionRoughness.r, uOcclusionStrength);
  // The paper's highlight is constant; here roughness attenuates it.
  float gloss = 1.0 - occlusionRoughness.g * uSurface.x;
  float specular = SPECULAR * gloss * highlight(dot(normal, halfway)) * step(1e-3, diffuse);
  vec3 color = (albedo * diffuse + albedo * specular) * light.color * attenuation(distance);
  oColor = vec4(display(color * frame.exposure, gl_FragCoord.xy).rgb, edgeCode(0.0));
}
