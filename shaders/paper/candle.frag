#version 300 es
// The candle by the paper's lighting: Phong in world space with an ambient share, attenuated.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "paper/light.glsl"
#include "lib/normal-map.glsl"
#include "lib/srgb.glsl"

const float AMBIENT = 0.5;
const float SPECULAR = 0.3;
const float EXPONENT = 16.0;
// Wax passes light on downwards: the ambient share fades with depth below the flame, in candle
// heights. The paper's is the same everywhere, which makes the foot glow as the rim does.
const float AMBIENT_DEPTH = 0.35;

uniform sampler2D uAlbedo;
uniform sampler2D uNormal;
uniform sampler2D uOcclusionRoughness;
uniform vec4 uBaseColor;
uniform float uOcclusionStrength;  // how much of the map's occlusion counts

in vec3 vPositionWorld;
in vec3 vNormalWorld;
in vec4 vTangentWorld;
in vec2 vUv;
in float vHeight;

out vec4 oColor;

vec3 surfaceNormal() {
  if (light.flatShading > 0.5) return facetNormal(vPositionWorld);
  if (frame.normalMaps > 0.5) return perturbedNormal(uNormal, vUv, vNormalWorld, vTangentWorld);
  return normalize(vNormalWorld);
}

void main() {
  vec3 albedo = texture(uAlbedo, vUv).rgb * uBaseColor.rgb;
  float occlusion = mix(1.0, texture(uOcclusionRoughness, vUv).r, uOcclusionStrength);
  vec3 normal = surfaceNormal();
  vec3 toLight = light.position - vPositionWorld;
  float distance = length(toLight);
  vec3 lightDirection = toLight / max(distance, 1e-3);  // the flame is over 1 mm thick
  vec3 viewDirection = normalize(frame.eyePosition - vPositionWorld);
  float ambient = AMBIENT * exp(-max(1.0 - vHeight, 0.0) / AMBIENT_DEPTH);
  float diffuse = max(dot(normal, lightDirection), 0.0);
  float specular = SPECULAR * pow(max(dot(reflect(-lightDirection, normal), viewDirection), 0.0), EXPONENT);
  vec3 color = ((ambient + diffuse) * occlusion * albedo + specular * step(1e-3, diffuse) * albedo)
    * light.color * attenuation(distance);
  oColor = display(color * frame.exposure, gl_FragCoord.xy);
}
