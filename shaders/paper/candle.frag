#version 300 es
// The candle by the paper's lighting: Phong in world space with an ambient share, attenuated.
// Out: display colour; alpha may tell surfaces apart.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "paper/light.glsl"
#include "paper/surface.glsl"
#include "lib/srgb.glsl"

const float AMBIENT = 0.5;
const float SPECULAR = 0.3;
// Depth below the flame at which the ambient share has fallen to 1/e, in candle heights: wax scatters light downwards.
// The paper's share is constant, which makes the foot glow as the rim does.
const float AMBIENT_DEPTH = 0.35;

in float vHeight;

out vec4 oColor;

void main() {
  vec3 albedo = albedoHere();
  float occlusion = mix(1.0, texture(uOcclusionRoughness, vUv).r, uOcclusionStrength);
  vec3 normal = surfaceNormal();
  vec3 toLight = light.position - vPositionWorld;
  float distance = length(toLight);
  vec3 lightDirection = toLight / max(distance, 1e-3);  // the flame is over 1 mm thick
  vec3 viewDirection = normalize(frame.eyePosition - vPositionWorld);
  float ambient = AMBIENT * exp(-max(1.0 - vHeight, 0.0) / AMBIENT_DEPTH);
  float diffuse = max(dot(normal, lightDirection), 0.0);
  float specular = SPECULAR * highlight(dot(reflect(-lightDirection, normal), viewDirection));
  vec3 color = ((ambient + diffuse) * occlusion * albedo + specular * step(1e-3, diffuse) * albedo)
    * light.color * attenuation(distance);
  oColor = vec4(display(color * frame.exposure, gl_FragCoord.xy).rgb, edgeCode(0.5));
}
