#version 300 es
// First bounce at the hits of the probes' rays: direct light, by the weight of the rays against the surfels.
// Out: radiance times solid angle of four rays side by side, cd/m² sr.
#include "lib/precision.glsl"
#include "lib/probe-rays.glsl"
#ifdef MOON
#include "lib/moon.glsl"
#else
#include "lib/flame-light.glsl"
#include "lib/pool-reflection.glsl"
#endif
#include "lib/surfels.glsl"
#include "lib/glossy-lobe.glsl"
#ifndef MOON
#include "lib/shadow-cube.glsl"
#endif

// A surface this far behind the nearest one in its direction is lit, m.
const float BIAS = 0.02;
// A plane seen edge on reaches no farther than this many times the distance of the point.
const float STEEPEST = 1.1;

uniform sampler2D uProbePositions;  // m
uniform sampler2D uRayReflectance;
uniform vec3 uShadowOrigin;  // m

out vec4 oRadiance;

#ifdef MOON
uniform highp sampler2D uShadow;  // the moon's map

// Most that a half float, as of a ray's reach, is off by: as a share.
const float HALF_ROUNDING = 1.0 / 2048.0;

// Compared with the lit plane at the texel's centre.
bool isLit(vec3 position, vec3 normal, float NoL, float bias) {
  vec3 place = onMoonMap(position);
  if (!isOnMap(place.xy) || !isInBeam(position)) return false;
  vec2 texels = vec2(textureSize(uShadow, 0));
  vec2 offset = (floor(place.xy * texels) + 0.5) / texels - place.xy;
  float slope = (dot(normal, moon.across) * offset.x + dot(normal, moon.up) * offset.y) / limitedCosine(NoL);
  float caster = texelFetch(uShadow, ivec2(place.xy * texels), 0).r * moon.depth;
  return place.z + slope <= caster + bias;
}

// Radiance that a probe receives along a ray, by the weight of the ray; the sky's through panes.
vec3 radianceAlong(ProbeRay ray, vec3 position) {
  bool isPane = isOnPane(position);
  float NoL = -dot(ray.normal, moon.direction);
  float bias = max(MOON_BIAS, ray.reach * HALF_ROUNDING);
  if (!isPane && (NoL <= 0.0 || !isLit(position, ray.normal, NoL, bias))) return vec3(0.0);
  float columns = moon.surfelColumns;
  float area = isPane ? moon.paneArea / columns * float(uGroup) : float(uGroup * uGroup) * moon.surfelArea / limitedCosine(NoL);
  float fromProbe = max(dot(ray.normal, -ray.direction), 0.0) * area / (ray.reach * ray.reach);
  vec4 reflectance = texelFetch(uRayReflectance, ray.texel, 0);
  vec3 reflected = reflectance.rgb * (NoL * glossyLobe(reflectance.a, ray.normal, -moon.direction, -ray.direction));
  vec3 radiance = isPane ? vec3(moon.sky * paneShare(ray.direction)) : reflected;
  return radiance * rayWeight(fromProbe, ray.solidAngle);
}
#else
// The lit plane is compared with the nearest caster where the ray through the texel's centre meets it.
bool isLit(vec3 position, vec3 normal) {
  vec3 fromOrigin = position - uShadowOrigin;
  bvec2 axis = shadowAxis(fromOrigin);
  vec3 point = onShadowFace(fromOrigin, axis);
  vec3 n = onShadowFace(normal, axis);
  float tile = shadowTileSize();
  float texels = 0.5 * tile / SHADOW_REACH;  // for a length of 1 on a face
  vec2 tileCenter = shadowTileCenter(axis, point.z, light.shadowSlot, tile);
  vec2 texel = floor(tileCenter + point.xy / point.z * texels);
  vec2 center = (texel + 0.5 - tileCenter) / texels;
  float share = dot(n, point / point.z) / dot(n, vec3(center, 1.0));  // of the point's distance along the axis
  float plane = abs(point.z) * (share > 0.0 ? min(share, STEEPEST) : STEEPEST);
  return plane <= SHADOW_NEAR / max(1.0 - shadowDepth(texel), SHADOW_STEP) + BIAS;
}

// Radiance that a probe receives along a ray, by the weight of the ray.
vec3 radianceAlong(ProbeRay ray, vec3 position) {
  vec3 fromLight = position - light.captureOrigin;
  float distanceSquared = dot(fromLight, fromLight);
  vec3 lightDirection = fromLight * inversesqrt(distanceSquared);
  float NoL = dot(ray.normal, -lightDirection);
  if (NoL <= 0.0 || !isLit(position, ray.normal)) return vec3(0.0);
  // Of a group of surfels at the hit, from the probe.
  float area = float(uGroup * uGroup) * surfelSolidAngle(lightDirection) * distanceSquared / limitedCosine(NoL);
  float fromProbe = max(dot(ray.normal, -ray.direction), 0.0) * area / (ray.reach * ray.reach);
  vec3 irradiance = light.intensity * (NoL / distanceSquared * candleVisibility(position) * withPool(-fromLight, distanceSquared));
  vec4 reflectance = texelFetch(uRayReflectance, ray.texel, 0);
  vec3 radiance = reflectance.rgb * irradiance * glossyLobe(reflectance.a, ray.normal, -lightDirection, -ray.direction);
  return radiance * rayWeight(fromProbe, ray.solidAngle);
}
#endif

void main() {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 4; i++) {
    ProbeRay ray = probeRayAt(2 * ivec2(gl_FragCoord.xy) + ivec2(i & 1, i >> 1));
    if (ray.reach <= 0.0) continue;
    vec3 position = texelFetch(uProbePositions, ray.tile, 0).xyz + ray.direction * ray.reach;
    sum += radianceAlong(ray, position) * ray.solidAngle;
  }
  oRadiance = vec4(sum, 1.0);
}
