#version 300 es
// Deferred lighting for a moon of 1 lx, and the night behind panes, at the rate of the flame's.
// In:  G-buffer, the moon's map, its irradiance volume.
// Out: square roots of the albedo's factor, cd/m², and of what is added to it. The moon's light is colourless here.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/octahedral.glsl"
#include "lib/random.glsl"
#include "lib/depth.glsl"
#include "lib/brdf.glsl"
#include "lib/moon.glsl"
#include "lib/moon-shadow.glsl"
#include "lib/night-sky.glsl"
#include "lib/irradiance-volume.glsl"
#include "lib/gbuffer.glsl"
#if !REDUCED
#include "lib/representative-sample.glsl"
#endif
#include "lib/lighting-texel.glsl"

uniform sampler2D uGBufferAlbedo;
uniform vec3 uFeatures;  // 1 or 0: shadows, indirect light, specular

out vec4 oLighting;

// Footprint at most: neighbours may be of surfaces far apart, m.
const float WIDEST = 0.04;

void main() {
  LightingTexel texel = lightingTexel();
  vec3 normal = texel.normal;
  vec3 L = -moon.direction;
  float NoL = max(dot(normal, L), 0.0);
  vec2 tile = mod(floor(gl_FragCoord.xy), 2.0);
  float footprint = max(length(dFdx(texel.position)), length(dFdy(texel.position)));
  float visibility = NoL > 0.0 ? moonVisibility(texel.position, normal, tile, min(footprint, WIDEST)) : 0.0;
  visibility = mix(1.0, visibility, uFeatures.x);
  float metallic = metallicOf(texel.material);
  vec3 toEye = normalize(frame.eyePosition - texel.position);
  float NoV = max(abs(dot(normal, toEye)), 1e-3);
  float alpha = texel.roughness * texel.roughness;
  float widened = clamp(alpha + 0.5 * MOON_TANGENT, 0.0, 1.0);
  vec3 H = normalize(L + toEye);
  float fresnel = fresnelSchlick(vec3(0.04), max(dot(L, H), 0.0)).r;
  float specular = distributionGgx(widened, max(dot(normal, H), 0.0)) * visibilitySmith(alpha, NoV, NoL);
  specular *= alpha * alpha / (widened * widened) * NoL * visibility * uFeatures.z;
  float factor = (1.0 - metallic) * (1.0 - fresnel) / PI * NoL * visibility + metallic * specular;
  float added = (1.0 - metallic) * fresnel * specular;

  vec3 reflected = reflect(-toEye, normal);
  IrradianceSample indirect = irradianceAt(texel.position + normal * 0.08, normal, normal, reflected);
  float mirrored = fresnelSchlick(vec3(0.04), NoV).r;
  vec3 perLux = factor + indirect.alongNormal * ((1.0 - metallic) * (1.0 - mirrored) / PI * uFeatures.y);
  vec3 room = indirect.alongReflection / PI * ((1.0 - 0.6 * texel.roughness) * uFeatures.y * uFeatures.z);
  perLux += metallic * room;
  added += (1.0 - metallic) * mirrored * luma(room);
  if (isGlass(texel.material) && isOnPane(texel.position)) {
    // The part without albedo has the flame's colour while that burns, so the night is in the albedo's factor.
    vec4 albedo = texture(uGBufferAlbedo, texel.onScreen);
    float glass = max(ALBEDO_SCALE * albedo.g * albedo.g, 1e-3);
    perLux += nightThroughPane(-toEye, NoV) / glass;
  }
  oLighting = sqrt(clamp(vec4(perLux, added), 0.0, 3e4));
}
