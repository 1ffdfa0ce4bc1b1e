#version 300 es
// Surface of the lone candle, in the light of its flame and of a studio environment.
// In:  base colour (sRGB), normal, occlusion/roughness/metallic maps.   Out: radiance, cd/m²; alpha 1.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/photometry.glsl"
#include "lib/normal-map.glsl"
#include "lib/flame-light.glsl"
#include "lib/flame-brdf.glsl"
#include "lib/wax.glsl"
#include "lib/ember.glsl"
#include "lib/studio.glsl"
#include "lib/mesh-fragment.glsl"

uniform float uWax;        // 1: subsurface scattering, 0: none
uniform vec3 uEmber;       // radiance of the wick's glowing tip, cd/m²; black for other materials

out vec4 oRadiance;

void main() {
  vec4 baseColor = texture(uAlbedo, vUv) * uBaseColor;
  if (baseColor.a < uSurface.w) discard;
  vec3 packed = texture(uOcclusionRoughness, vUv).rgb;
  float occlusion = mix(1.0, packed.r, uOcclusionStrength) * vColor.r;
  float roughness = clamp(packed.g * uSurface.x, 0.03, 1.0);
  float metallic = packed.b * uSurface.y;
  vec3 normal = directionOf(vNormalWorld);
  if (frame.normalMaps > 0.5) {
    normal = perturbedNormal(texture(uNormal, vUv).xy, normal, vTangentWorld, uSurface.z);
  }
  vec3 view = normalize(frame.eyePosition - vPositionWorld);
  float NoV = max(abs(dot(normal, view)), 1e-3);
  vec3 toLight = light.position - vPositionWorld;
  float distanceSquared = max(dot(toLight, toLight), LEAST_DISTANCE * LEAST_DISTANCE);
  float NoL = max(dot(normal, toLight) * inversesqrt(distanceSquared), 0.0);
  if (uWax > 0.5) NoL = waxCosine(directionOf(vNormalWorld), vPositionWorld, toLight);
  vec3 perArea = light.intensity * (candleVisibility(vPositionWorld) / distanceSquared);
  vec3 halfAxis = light.along * light.halfHeight;
  FlameSpecular flame = flameSpecular(toLight, halfAxis, light.radius, normal, view, NoV, roughness * roughness);
  vec3 f0 = mix(vec3(0.04), baseColor.rgb, metallic);
  vec3 fresnel = fresnelSchlick(f0, flame.SoH);
  vec3 specular = fresnel * flame.lobe * perArea;
  vec3 diffuseColor = baseColor.rgb * (1.0 - metallic);
  vec3 diffuse = diffuseColor * (1.0 - fresnel) / PI * NoL * perArea;
  vec3 reflected = environment(mix(reflect(-view, normal), normal, roughness * 0.7));
  vec3 ambient = diffuseColor * environment(normal) + fresnelSchlick(f0, NoV) * reflected;
  vec3 radiance = diffuse + specular + ambient * occlusion + baseColor.rgb * waxGlow(vPositionWorld) * uWax;
  radiance += uEmber * emberShare(vPositionWorld - vec3(light.axis.x, light.rim, light.axis.y));
  oRadiance = vec4(min(radiance, 3e4), 1.0);  // the largest half float is 65504
}
