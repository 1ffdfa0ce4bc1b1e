#version 300 es
// A solid surface in the flame's light.
// In:  base colour (sRGB), normal, occlusion/roughness/metallic maps.   Out: radiance, cd/m².
// Vertex colour is occlusion baked into the model (red), 1 where there is none.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/octahedral.glsl"
#include "lib/normal-map.glsl"
#include "lib/random.glsl"
#include "lib/flame-light.glsl"
#include "lib/flame-brdf.glsl"
#include "lib/pcss.glsl"
#include "lib/surfels.glsl"
#include "lib/distance-impostor.glsl"
#include "lib/irradiance-volume.glsl"
#include "lib/wax.glsl"

// Levels of detail by which textures are read more sharply: each mixes more than its pixel sees.
const float SHARPER = -0.5;

// Less of the sky than this is seen from a crevice.
const float OPEN = 0.9;
// Roughness up to which a surface is a mirror, and from which it tells no more than probes do.
const vec2 SMOOTH = vec2(0.1, 0.3);
// What a room throws back of its light that has bounced.
const float THROWN_BACK = 0.3;
// What is nearer than probes are to each other: there is some of it even where nothing is occluded. It hides what
// they see, and sends back light itself, up to so many times theirs. Fitted to a path tracer's bounced light.
const float NEAR_ANYWHERE = 0.25;
const float NEAR_HIDES = 0.31;
const float NEAR_SENDS = 0.25;
const float NEAR_MOST = 13.0;
// They reach up into the light by so much, m, though the bottom may lie in their shadow.
const float SIDES = 0.015;
// The wick stands in the flame, which is on all of its sides: what reaches it through dark vapour.
const float IN_FLAME = 0.05;

uniform sampler2D uAlbedo;
uniform sampler2D uNormal;
uniform sampler2D uOcclusionRoughness;
uniform sampler2D uEnvironmentBrdf;
uniform sampler2D uNormalMapVisibility;   // shares that relief leaves of light where it is too fine to be seen, by level
uniform vec4 uBaseColor;
uniform float uWax;     // 1: light from within, 0: none
uniform float uOcclusionStrength;  // how much of the map's occlusion counts
uniform vec4 uFeatures;    // 1 or 0: shadows, bounced light, highlights; normals instead of all light
uniform float uIsWick;  // 1 or 0
uniform vec4 uSurface;  // roughness, metallic, normal scale, alpha below which nothing is

// Where the pixel is covered: beyond the edge of a thin triangle nothing is known.
centroid in vec3 vPositionWorld;
centroid in vec3 vNormalWorld;
centroid in vec4 vTangentWorld;
centroid in vec2 vUv;
centroid in vec4 vColor;

out vec4 oRadiance;

vec3 shadingNormal(vec3 surface) {
  if (frame.normalMaps < 0.5) return surface;
  vec3 relief = applyNormalMap(texture(uNormal, vUv, SHARPER).xy, surface, vTangentWorld);
  return normalize(mix(surface, relief, uSurface.z));
}

// Shares of light from all around, and of the flame's, that relief leaves which is finer than a pixel.
vec2 minifiedVisibility() {
  if (frame.normalMaps < 0.5) return vec2(1.0);
  vec2 texels = vec2(textureSize(uNormal, 0));
  float inPixel = abs(determinant(mat2(dFdx(vUv) * texels, dFdy(vUv) * texels)));
  float level = 0.5 * log2(max(inPixel, 1.0));
  return textureLod(uNormalMapVisibility, vec2((level + 0.5) / float(textureSize(uNormalMapVisibility, 0).x), 0.5), 0.0).rg;
}

// How much of the flame a place sees past the room, candle and holder.
float directVisibility(vec3 position, vec3 facet) {
  return flameVisibility(position, facet, gl_FragCoord.xy) * candleVisibility(position);
}

void main() {
  vec4 baseColor = texture(uAlbedo, vUv, SHARPER) * uBaseColor;
  if (baseColor.a < uSurface.w) discard;
  vec3 packed = texture(uOcclusionRoughness, vUv, SHARPER).rgb;
  float occlusion = mix(1.0, packed.r, uOcclusionStrength) * vColor.r;
  float roughness = clamp(packed.g * uSurface.x, 0.03, 1.0);
  float metallic = packed.b * uSurface.y;
  vec3 surface = normalize(vNormalWorld) * (gl_FrontFacing ? 1.0 : -1.0);
  vec3 normal = shadingNormal(surface);
  vec3 view = normalize(frame.eyePosition - vPositionWorld);
  float NoV = max(abs(dot(normal, view)), 1e-3);

  vec3 toLight = light.position - vPositionWorld;
  float distanceSquared = max(dot(toLight, toLight), LEAST_DISTANCE * LEAST_DISTANCE);
  vec3 L = toLight * inversesqrt(distanceSquared);
  float NoL = max(dot(normal, L), 0.0);
  vec3 facet = facetNormal(vPositionWorld);
  facet = faceforward(facet, vPositionWorld - light.position, facet);
  // Crevices are lit by what is beside them, so the flame's light counts there whichever way they face.
  bool isCrevice = occlusion < OPEN;
  float reached = NoL > 0.0 || isCrevice ? directVisibility(vPositionWorld, facet) : 0.0;
  float reachesSides = reached;
  if (isCrevice && reached < 1.0) reachesSides = max(reached, directVisibility(vPositionWorld + surface * SIDES, facet));
  float inFlame = uIsWick * IN_FLAME;
  if (inFlame > 0.0) reached = 1.0;
  vec3 free = light.intensity / distanceSquared;
  vec3 passing = free * mix(1.0, reached, uFeatures.x);
  vec3 passingSides = free * mix(1.0, reachesSides, uFeatures.x);
  vec2 pastFine = minifiedVisibility();
  vec3 irradiance = passing * max(NoL * normalMapVisibility(surface, normal, L) * pastFine.y, inFlame);

  float alpha = specularAntialiasing(roughness * roughness, normal);
  FlameSpecular flame = flameSpecular(toLight, normal, view, NoV, alpha);
  vec3 f0 = mix(vec3(0.04), baseColor.rgb, metallic);
  EnvironmentReflection mirroring = environmentReflection(uEnvironmentBrdf, f0, sqrt(alpha), NoV);
  vec3 specular = fresnelSchlick(f0, flame.SoH) * mirroring.boost * flame.lobe * passing * uFeatures.z;
  // What the surface mirrors does not reach the matt layer below.
  vec3 matt = baseColor.rgb * (1.0 - metallic) * (1.0 - mirroring.share);
  vec3 diffuse = matt / PI * irradiance;
  vec3 lifted = vPositionWorld + surface * 0.05;
  IrradianceSample indirect = irradianceAt(lifted, normal, normal, reflect(-view, normal));
  vec3 around = indirect.alongNormal * light.intensity;
  float near = 1.0 - occlusion + NEAR_ANYWHERE;
  float unhidden = 1.0 - NEAR_HIDES * near;
  // It is as bright as this place, and as far from the flame.
  vec3 nearby = NEAR_SENDS * near * baseColor.rgb * passingSides;
  nearby /= 1.0 + passingSides / max(NEAR_MOST * around, 1e-9);
  vec3 bounced = (around * unhidden + nearby) * matt * (skyVisibility(surface, normal) * pastFine.x / PI);
  // What is mirrored is the room around, as softParticleFade as it is known: a smooth surface tells more.
  vec3 mirrored = (indirect.alongReflection * light.intensity * unhidden + nearby) / PI;
  float smoothness = 1.0 - smoothstep(SMOOTH.x, SMOOTH.y, roughness);
  if (smoothness > 0.0) {
    vec3 again = indirect.alongReflection * (THROWN_BACK / PI);
    vec3 seen = (traceRadiance(vPositionWorld + surface * 0.01, reflect(-view, normal)) + again) * light.intensity;
    mirrored = mix(mirrored, seen, smoothness);
  }
  mirrored *= mirroring.share;
  bounced = (bounced + mirrored * uFeatures.z) * uFeatures.y;
  vec3 radiance = diffuse + specular + bounced + baseColor.rgb * waxGlow(vPositionWorld) * uWax;
  // A mirrored flame can be brighter than the largest half float, 65504.
  oRadiance = vec4(uFeatures.w > 0.5 ? 0.5 + 0.5 * normal : min(radiance, 3e4), 1.0);
}
