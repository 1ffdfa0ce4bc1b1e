#version 300 es
// Surface of a visitor's own candles, in the light of all their flames and of a studio environment.
// SHADOW_TAPS: samples of soft shadows; without them there are none, as on what transmits most of the light.
// In:  base colour (sRGB), normal, occlusion/roughness/metallic maps.   Out: radiance, cd/m², premultiplied.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/photometry.glsl"
#include "lib/flame-brdf.glsl"
#include "lib/normal-map.glsl"
#include "lib/studio.glsl"
#include "lib/ember.glsl"
#include "lib/candle-flames.glsl"
#define FLAMES
#include "lib/flame-light.glsl"
#include "lib/wax.glsl"
#ifdef SHADOW_TAPS
#define SHADOW_NEAR 0.004
#include "lib/flame-shadows.glsl"
#endif
#include "lib/mesh-fragment.glsl"

uniform vec3 uBounce;             // radiance of the model around, cd/m²
uniform float uWax;               // 1: light of the flame above leaves it below, 0: none
uniform float uWick;              // 1: its tip glows
uniform float uTransmission;      // transmitted share of the light, 0 to 1
uniform float uOpacity;           // 1: alpha counts, 0: it is opaque

out vec4 oRadiance;

// Diffusion length of thick white paraffin, m, its reflectance, and the share of the light on its top that leaves through
// the side.
const vec3 PILLAR_DIFFUSION_LENGTH = vec3(0.014, 0.0105, 0.007);
const vec3 WHITE_WAX = vec3(0.84, 0.78, 0.66);
const float PILLAR_TRANSMITTANCE = 0.2;
// Wax begins so far below the root of the flame, m, and its wall ends so far above that: higher wax is another candle's.
const float RIM = 0.003;
const float WALL_HEIGHT = 0.012;
// Share by which coloured glass absorbs the complement of its colour.
const float TINT = 0.6;

// Diffusion length of wax, m: light ends sooner in dyed wax, with the root of its absorption, which follows from its
// reflectance. Kubelka and Munk 1931, "Ein Beitrag zur Optik der Farbanstriche".
vec3 diffusionLength(vec3 reflectance) {
  vec3 absorption = (1.0 - reflectance) * inversesqrt(max(reflectance, 1e-3));
  return PILLAR_DIFFUSION_LENGTH * min((1.0 - WHITE_WAX) * inversesqrt(WHITE_WAX) / max(absorption, 1e-3), 1.0);
}

FlameLight flameLight(int i) {
  vec3 root = flames.roots[i].xyz;
  vec3 captureOrigin = root + vec3(0.0, flames.roots[i].w, 0.0);
  vec4 centre = flames.centres[i];
  vec4 along = flames.alongs[i];
  vec4 intensity = flames.intensities[i];
  return FlameLight(
    centre.xyz, centre.w, intensity.rgb, along.w, root.xz, root.y - RIM, 0.0, 0.0, 0.0, captureOrigin, intensity.w, along.xyz
  );
}

vec3 emberGlow(int i, vec3 position) {
  vec4 ember = flames.embers[i];
  return ember.rgb * emberShare(position - flames.roots[i].xyz + vec3(0.0, WICK_END - ember.w, 0.0));
}

void main() {
#ifdef SHADOW_TAPS
  vec3 facet = facetNormal(vPositionWorld);
#endif
  vec4 baseColor = texture(uAlbedo, vUv) * uBaseColor * vColor;
  if (uOpacity < 0.5 && baseColor.a < uSurface.w) discard;
  vec3 packed = texture(uOcclusionRoughness, vUv).rgb;
  float occlusion = mix(1.0, packed.r, uOcclusionStrength);
  float roughness = clamp(packed.g * uSurface.x, 0.03, 1.0);
  float metallic = packed.b * uSurface.y;
  vec3 normal = directionOf(vNormalWorld) * (gl_FrontFacing ? 1.0 : -1.0);
  if (frame.normalMaps > 0.5) {
    normal = perturbedNormal(texture(uNormal, vUv).xy, normal, vTangentWorld, uSurface.z);
  }
#ifdef SHADOW_TAPS
  facet = faceforward(facet, -normal, facet);
#endif
  vec3 view = normalize(frame.eyePosition - vPositionWorld);
  float NoV = max(abs(dot(normal, view)), 1e-3);
  vec3 f0 = mix(vec3(0.04), baseColor.rgb, metallic);
  vec3 diffuseColor = baseColor.rgb * (1.0 - metallic);
  float alpha = roughness * roughness;
  vec3 diffuse = vec3(0.0);
  vec3 specular = vec3(0.0);
  vec3 glow = vec3(0.0);
  vec3 diffusion = diffusionLength(baseColor.rgb);
  for (int i = 0; i < int(flames.count); i++) {
    light = flameLight(i);
    vec3 leaving = waxTransmission(vPositionWorld, diffusion, PILLAR_TRANSMITTANCE) * light.intensity / PI;
    leaving *= exp(-max(vPositionWorld.y - light.rim - WALL_HEIGHT, 0.0) / diffusion);
    glow += baseColor.rgb * leaving * uWax + emberGlow(i, vPositionWorld) * uWick;
    vec3 toLight = light.position - vPositionWorld;
    float distanceSquared = max(dot(toLight, toLight), LEAST_DISTANCE * LEAST_DISTANCE);
    float cosine = max(dot(normal, toLight * inversesqrt(distanceSquared)), 0.0);
    float NoL = uWax > 0.5 ? softCosine(normal, toLight) : cosine;
    vec3 halfAxis = light.along * light.halfHeight;
    FlameSpecular flame = flameSpecular(toLight, halfAxis, light.radius, normal, view, NoV, alpha);
    if (NoL + flame.lobe <= 0.0) continue;
    vec3 perArea = light.intensity / distanceSquared;
#ifdef SHADOW_TAPS
    perArea *= flameVisibility(vPositionWorld, facet, gl_FragCoord.xy);
#endif
    vec3 fresnel = fresnelSchlick(f0, flame.SoH);
    diffuse += diffuseColor * (1.0 - fresnel) / PI * NoL * perArea;
    specular += fresnel * flame.lobe * perArea;
  }
  vec3 reflected = environment(mix(reflect(-view, normal), normal, roughness * 0.7));
  vec3 mirrored = fresnelSchlick(f0, NoV);
  diffuse += diffuseColor * (environment(normal) + uBounce) * occlusion;
  specular += mirrored * reflected * occlusion;
  // Of glass and blended surfaces: diffuse light by coverage, specular light in full.
  float covered = mix(1.0, baseColor.a * (1.0 - uTransmission), uOpacity);
  float tint = uTransmission * TINT * (1.0 - luma(baseColor.rgb));
  float passes = (1.0 - covered) * (1.0 - luma(mirrored)) * (1.0 - tint);
  vec3 radiance = (diffuse + glow) * covered + specular;
  oRadiance = vec4(min(radiance, 3e4), 1.0 - passes);  // the largest half float is 65504
}
