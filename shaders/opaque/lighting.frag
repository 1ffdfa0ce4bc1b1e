#version 300 es
// Deferred lighting at a lower rate than the G-buffer's, for a flame of 1 cd.
// In:  G-buffer, shadow cube, irradiance volume.
// Out: square roots of the albedo's factor, cd/m², and of what is added to it; REDUCED: inverse depth.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/octahedral.glsl"
#include "lib/random.glsl"
#include "lib/depth.glsl"
#include "lib/flame-light.glsl"
#include "lib/flame-brdf.glsl"
#include "lib/shadow-cube.glsl"
#include "lib/pcss.glsl"
#include "lib/irradiance-volume.glsl"
#include "lib/wax.glsl"
#include "lib/gbuffer.glsl"
#if !REDUCED
#include "lib/representative-sample.glsl"
#endif
#include "lib/lighting-texel.glsl"
#include "lib/support-irradiance.glsl"

uniform vec3 uFeatures;  // 1 or 0: shadows, indirect light, specular

layout(location = 0) out vec4 oLighting;
#if REDUCED
layout(location = 1) out vec4 oInverseDepth;
#endif

void main() {
  LightingTexel texel = lightingTexel();
  vec3 position = texel.position;
  vec3 normal = texel.normal;
  float material = texel.material;
  float roughness = texel.roughness;
#if REDUCED
  oInverseDepth = vec4(inverseDepth(texel.depth), 0.0, 0.0, 1.0);
#endif
  // Computed first, to save registers. Four rotations of the taps side by side, which the upsampling averages.
  float visibility = 0.0;
  if (dot(normal, light.position) > dot(normal, position)) {
    vec2 tile = mod(floor(gl_FragCoord.xy), 2.0);
    visibility = candleVisibility(position);
    visibility *= flameVisibility(uShadow, SHADOW_SEARCH, SHADOW_TAPS, position, normal, 0.0, tile).x;
  }
  float metallic = metallicOf(material);
  vec3 view = normalize(frame.eyePosition - position);
  float NoV = max(abs(dot(normal, view)), 1e-3);

  vec3 toLight = light.position - position;
  float distanceSquared = max(dot(toLight, toLight), LEAST_DISTANCE * LEAST_DISTANCE);
  vec3 L = toLight * inversesqrt(distanceSquared);
  float NoL = max(dot(normal, L), 0.0);
  float perArea = mix(1.0, visibility, uFeatures.x) / distanceSquared;
  float irradiance = isGlass(material) ? min(NoL * perArea, PANE_IRRADIANCE) : NoL * perArea;
  FlameSpecular flame = flameSpecular(toLight, normal, view, NoV, roughness * roughness);
  float fresnel = fresnelSchlick(vec3(0.04), flame.SoH).r;  // of a dielectric; a metal's is its albedo
  float specular = flame.lobe * perArea * uFeatures.z;
  // Factor of the albedo, and the part without albedo.
  vec3 perCandela = vec3((1.0 - metallic) * (1.0 - fresnel) / PI * irradiance + metallic * specular);
  float added = (1.0 - metallic) * fresnel * specular;

  vec3 reflected = reflect(-view, normal);
  IrradianceSample indirect = irradianceAt(position + normal * 0.08, normal, normal, reflected);
  float mirrored = dielectricShare(roughness, NoV);
  float diffuse = (1.0 - metallic) * (1.0 - mirrored) / PI;
  perCandela += (indirect.alongNormal + supportIrradiance(position, supportViewFactor(normal))) * (diffuse * uFeatures.y);
  vec3 room = (indirect.alongReflection + supportIrradiance(position, 0.5 - 0.5 * reflected.y)) / PI;
  room *= (1.0 - 0.6 * roughness) * uFeatures.y * uFeatures.z;
  perCandela += metallic * room;
  added += (1.0 - metallic) * mirrored * luma(room);
  if (isWax(material)) perCandela += waxGlow(position);
  oLighting = sqrt(clamp(vec4(perCandela, added), 0.0, 3e4));
}
