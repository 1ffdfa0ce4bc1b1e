#version 300 es
// Deferred lighting for a moon of 1 lx, and the night behind panes, at the rate of the flame's.
// REDUCED: direct light and night alone.
// In:  G-buffer, the moon's map, its irradiance volume.
// Out: square roots of the albedo's factor, cd/m², and of what is added to it. The moon's light is colourless here.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/compile-time.glsl"
#include "lib/octahedral.glsl"
#include "lib/depth.glsl"
#include "lib/brdf.glsl"
#include "lib/dielectric.glsl"
#include "lib/moon.glsl"
#include "lib/moon-shadow.glsl"
#include "lib/night-sky.glsl"
#include "lib/gbuffer.glsl"
#if !REDUCED
#define VOLUME_TAPS COUNT(12)
#include "lib/irradiance-volume.glsl"
#include "lib/representative-sample.glsl"
#endif
#include "lib/lighting-texel.glsl"

uniform vec3 uFeatures;  // 1 or 0: shadows, indirect light, specular
uniform sampler2D uGBufferAlbedo;

out vec4 oLighting;

// Footprint at most: neighbours may be of surfaces far apart, m.
const float WIDEST = 0.04;

// Direct moonlight: factor of the albedo, and the part without albedo, cd/m². `seen`: 1 or 0, shadows and specular.
vec2 moonLighting(LightingTexel texel, vec3 toEye, float NoV, vec2 seen) {
  vec3 normal = texel.normal;
  vec3 L = -moon.direction;
  float NoL = max(dot(normal, L), 0.0);
  vec2 tile = mod(floor(gl_FragCoord.xy), 2.0);
  float footprint = max(length(dFdx(texel.position)), length(dFdy(texel.position)));
  float visibility = NoL > 0.0 ? moonVisibility(texel.position, normal, tile, min(footprint, WIDEST)) : 0.0;
  // Without shadows its light goes through walls, but no other way than through the panes.
  float perArea = isInBeam(texel.position) ? NoL * mix(1.0, visibility, seen.x) : 0.0;
  float metallic = metallicOf(texel.material);
  float alpha = texel.roughness * texel.roughness;
  vec3 H = normalize(L + toEye);
  float fresnel = fresnelSchlick(vec3(0.04), max(dot(L, H), 0.0)).r;
  float lobe = distributionGgx(widenedAlpha(alpha, MOON_TANGENT), max(dot(normal, H), 0.0)) * visibilitySmith(alpha, NoV, NoL);
  float specular = lobe * perArea * seen.y;
  float factor = (1.0 - metallic) * (1.0 - fresnel) / PI * perArea + metallic * specular;
  return vec2(factor, (1.0 - metallic) * fresnel * specular);
}

// The night behind a pane as a factor of the albedo: the part without albedo has the flame's colour while that burns.
float nightLighting(LightingTexel texel, vec3 toEye, float NoV) {
  bool isPane = isGlass(texel.material) && isOnPane(texel.position);
  float factor = 0.0;
  // A software renderer executes both sides of an `if`, but skips a loop that no pixel enters.
  for (int i = isPane ? 1 : 0; i > 0; i--) {
    vec4 albedo = texture(uGBufferAlbedo, texel.onScreen);
    factor = nightThroughPane(-toEye, NoV) / max(ALBEDO_SCALE * albedo.g * albedo.g, 1e-3);
  }
  return factor;
}

void main() {
  COMPILE_ONCE;
  LightingTexel texel = lightingTexel();
  vec3 normal = texel.normal;
  float metallic = metallicOf(texel.material);
  vec3 toEye = normalize(frame.eyePosition - texel.position);
  float NoV = max(abs(dot(normal, toEye)), 1e-3);
  vec2 direct = moonLighting(texel, toEye, NoV, uFeatures.xz);
  vec4 perLux = vec2(direct.x + nightLighting(texel, toEye, NoV), direct.y).xxxy;
#if !REDUCED
  vec3 reflected = reflect(-toEye, normal);
  IrradianceSample indirect = irradianceAt(texel.position, 0.08, normal, normal, reflected);
  float mirrored = dielectricShare(texel.roughness, NoV);
  perLux.rgb += indirect.alongNormal * ((1.0 - metallic) * (1.0 - mirrored) / PI * uFeatures.y);
  vec3 room = indirect.alongReflection / PI * ((1.0 - 0.6 * texel.roughness) * uFeatures.y * uFeatures.z);
  perLux.rgb += metallic * room;
  perLux.a += (1.0 - metallic) * mirrored * luma(room);
#endif
  // The background is no surface: without a normal and a roughness it would be a mirror.
  oLighting = texel.depth < 1.0 ? sqrt(clamp(perLux, 0.0, REDUCED == 1 ? 1e9 : 3e4)) : vec4(0.0);
}
