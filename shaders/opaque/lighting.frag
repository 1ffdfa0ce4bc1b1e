#version 300 es
// Deferred lighting at a lower rate than the G-buffer's, for a flame of 1 cd.
// OF_ALL: for all lights as they shine, with their irradiance volume: CANDLES, standing ones; WITH_MOON, the moon.
// In:  G-buffer, shadow cube, irradiance volume.
// Out: square roots of the albedo's factor, cd/m², and of what is added to it; REDUCED: inverse depth.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/compile-time.glsl"
#include "lib/depth.glsl"
#include "lib/flame-light.glsl"
#include "lib/pool-reflection.glsl"
#include "lib/flame-brdf.glsl"
#include "lib/dielectric.glsl"
#include "lib/environment-brdf.glsl"
#include "lib/pcss.glsl"
#define VOLUME_TAPS COUNT(12)
#include "lib/irradiance-volume.glsl"
#include "lib/wax.glsl"
#include "lib/gbuffer.glsl"
#if !REDUCED
#include "lib/representative-sample.glsl"
#endif
#include "lib/lighting-texel.glsl"
#include "lib/support-irradiance.glsl"
#if !REDUCED
#include "lib/surfels.glsl"
#include "lib/distance-impostor.glsl"
#endif

uniform vec3 uFeatures;  // 1 or 0: shadows, indirect light, specular
#ifdef OF_ALL
uniform vec3 uColor;              // of the light that represents all: luma 1
#endif
#ifdef WITH_MOON
uniform sampler2D uMoonLighting;  // of moon-lighting.frag, REDUCED
uniform vec3 uMoonlight;          // lx
#endif

layout(location = 0) out vec4 oLighting;
#if REDUCED
layout(location = 1) out vec4 oInverseDepth;
#endif

// Roughness of dielectrics up to which reflections are traced.
const float TRACED_ROUGHNESS = 0.3;
const int REFLECTION_RAYS = 10;
// Alpha from which normals differ by an edge, rather than by curvature.
const float EDGE_ALPHA = 0.2;
// Share of light from all around that single scattering in a rough metal loses, for a roughness of 1.
const float ROUGH_LOSS = 0.25;

struct Viewing {
  vec3 view;
  float NoV;
  vec3 reflected;
  float alpha;     // of GGX
  float mirrored;  // share of light from all around that a dielectric mirrors
  vec2 factors;    // of the irradiance by the normal, and by the reflection
};

Viewing viewingOf(LightingTexel texel) {
  float metallic = metallicOf(texel.material);
  Viewing v;
  v.view = normalize(frame.eyePosition - texel.position);
  v.NoV = max(abs(dot(texel.normal, v.view)), 1e-3);
  v.reflected = reflect(-v.view, texel.normal);
  // What is round has many normals within a texel: with one of them highlights would be beads. Panes are flat.
  float alpha = texel.roughness * texel.roughness;
  float widened = specularAntialiasing(alpha, texel.normal);
  v.alpha = widened < EDGE_ALPHA && !isGlass(texel.material) ? widened : alpha;
  v.mirrored = dielectricShare(texel.roughness, v.NoV);
  v.factors.x = (1.0 - metallic) * (1.0 - v.mirrored) / PI * uFeatures.y;
  v.factors.y = (1.0 - 0.6 * texel.roughness) / PI * uFeatures.y * uFeatures.z;
  return v;
}

// Lighting by one flame without the room's: its direct light, its support, and the wax that it shines through.
// Factor of the albedo (rgb), and the part without albedo, cd/m².
vec4 flameLighting(LightingTexel texel) {
  vec3 position = texel.position;
  vec3 normal = texel.normal;
  // Computed first, to save registers. Four rotations of the taps side by side, which the upsampling averages.
  float visibility = 0.0;
  bool isWaxy = isWax(texel.material);
  if (isWaxy && isOwnWax(position)) {
    visibility = candleVisibility(position);
  } else if (dot(normal, light.position) > dot(normal, position)) {
    vec2 tile = mod(floor(gl_FragCoord.xy), 2.0);
    visibility = candleVisibility(position);
    int search = visibility > 0.0 ? COUNT(SHADOW_SEARCH) : 0;
    visibility *= flameVisibility(search, COUNT(SHADOW_TAPS), position, normal, 0.0, tile, 1.0).x;
  }
  Viewing v = viewingOf(texel);
  float metallic = metallicOf(texel.material);
  vec3 toLight = light.position - position;
  float distanceSquared = max(dot(toLight, toLight), LEAST_DISTANCE * LEAST_DISTANCE);
  vec3 L = toLight * inversesqrt(distanceSquared);
  float NoL = isWaxy ? waxCosine(normal, position, toLight) : max(dot(normal, L), 0.0);
  float perArea = mix(1.0, visibility, uFeatures.x) / distanceSquared;
  float irradiance = NoL * perArea * withPool(toLight, distanceSquared);
  if (isGlass(texel.material)) irradiance = min(irradiance, PANE_IRRADIANCE);
  vec3 halfAxis = light.along * light.halfHeight;
  FlameSpecular flame = flameSpecular(toLight, halfAxis, light.radius, normal, v.view, v.NoV, v.alpha);
  float fresnel = fresnelSchlick(vec3(0.04), flame.SoH).r;  // of a dielectric; a metal's is its albedo
  float specular = flame.lobe * perArea * uFeatures.z;
  vec3 perCandela = vec3((1.0 - metallic) * (1.0 - fresnel) / PI * irradiance + metallic * specular);
  vec4 support = supportOfLight();
  perCandela += supportIrradiance(support, position, supportViewFactor(normal)) * v.factors.x;
  vec3 room = supportIrradiance(support, position, 0.5 - 0.5 * v.reflected.y) * v.factors.y;
  perCandela += metallic * room;
  float added = (1.0 - metallic) * (fresnel * specular + v.mirrored * luma(room));
  vec3 glow = isWaxy ? waxGlow(position) : vec3(0.0);
  return vec4(perCandela * light.intensity + glow, added * luma(light.intensity));
}

void main() {
  COMPILE_ONCE;
  LightingTexel texel = lightingTexel();
#if REDUCED
  oInverseDepth = vec4(inverseDepth(texel.depth), 0.0, 0.0, 1.0);
#endif

#ifdef CANDLES
  // In one loop, so that the function is compiled once.
  vec4 lighting = vec4(0.0);
  for (int i = -1; i < int(standing.count); i++) {
    isStanding = i >= 0;
    light = carried;
    if (isStanding) light = standing.candles[i];
    lighting += flameLighting(texel);
  }
#else
  vec4 lighting = flameLighting(texel);
#endif
#ifdef WITH_MOON
  vec4 perLux = texelFetch(uMoonLighting, ivec2(gl_FragCoord.xy), 0);
  lighting += perLux * perLux * vec4(uMoonlight, luma(uMoonlight));
#endif

  vec3 normal = texel.normal;
  float metallic = metallicOf(texel.material);
  Viewing v = viewingOf(texel);
  IrradianceSample indirect = irradianceAt(texel.position, 0.08, normal, normal, v.reflected);
  lighting.rgb += indirect.alongNormal * v.factors.x;
  vec4 perRoom = vec4(vec3(metallic), (1.0 - metallic) * v.mirrored);
  vec3 room = indirect.alongReflection * v.factors.y;
#if !REDUCED
  // In motion texels are so large that reflections would be blotches.
  if (metallic > 0.5 || texel.roughness < TRACED_ROUGHNESS) {
    vec3 beyond = indirect.alongReflection * (TRACED_INDIRECT / PI);
    float kept = (1.0 - ROUGH_LOSS * texel.roughness) * uFeatures.y * uFeatures.z;
    room = traceReflection(texel.position, normal, v.alpha, REFLECTION_RAYS, beyond) * kept;
  }
#endif
  lighting += vec4(room, luma(room)) * perRoom;
#ifdef OF_ALL
  lighting.rgb /= uColor;
#endif
  // The background is no surface: without a normal and a roughness it would be a mirror.
  oLighting = texel.depth < 1.0 ? sqrt(clamp(lighting, 0.0, 3e4)) : vec4(0.0);
}
