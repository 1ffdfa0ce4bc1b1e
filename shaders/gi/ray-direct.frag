#version 300 es
// First bounce at the hits of the probes' rays: direct light, by the weight of the rays against the surfels.
// Out: radiance times solid angle of four rays side by side, cd/m² sr.
#include "lib/precision.glsl"
#include "lib/octahedral.glsl"
#include "lib/photometry.glsl"
#include "lib/flame-light.glsl"
#include "lib/probe-rays.glsl"
#include "lib/surfels.glsl"
#include "lib/shadow-cube.glsl"

// A surface this far behind the nearest one in its direction is lit: m, and texels of the shadow cube.
const float BIAS = 0.02;
const float BIAS_TEXELS = 1.0;

uniform sampler2D uProbePositions;  // m
uniform sampler2D uRayReflectance;
uniform vec3 uShadowOrigin;  // m

out vec4 oRadiance;

bool isLit(vec3 position, float NoL) {
  vec3 fromOrigin = position - uShadowOrigin;
  float reach = length(fromOrigin);
  float texel = 2.0 * SHADOW_REACH * reach / shadowTileSize();
  return reach <= reach * casterDistance(fromOrigin) + BIAS + BIAS_TEXELS * texel / limitedCosine(NoL);
}

void main() {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 4; i++) {
    ProbeRay ray = probeRayAt(2 * ivec2(gl_FragCoord.xy) + ivec2(i & 1, i >> 1));
    vec3 position = texelFetch(uProbePositions, ray.tile, 0).xyz + ray.direction * ray.reach;
    vec3 fromLight = position - light.captureOrigin;
    float distanceSquared = dot(fromLight, fromLight);
    vec3 lightDirection = fromLight * inversesqrt(distanceSquared);
    float NoL = dot(ray.normal, -lightDirection);
    if (ray.reach <= 0.0 || NoL <= 0.0 || !isLit(position, NoL)) continue;
    // Of a group of surfels at the hit, from the probe.
    float area = float(GROUP * GROUP) * surfelSolidAngle(lightDirection) * distanceSquared / limitedCosine(NoL);
    float fromProbe = max(dot(ray.normal, -ray.direction), 0.0) * area / (ray.reach * ray.reach);
    vec3 irradiance = light.intensity * (NoL / distanceSquared * candleVisibility(position));
    vec3 radiance = texelFetch(uRayReflectance, ray.texel, 0).rgb * irradiance / PI;
    sum += radiance * rayWeight(fromProbe, ray.solidAngle) * ray.solidAngle;
  }
  oRadiance = vec4(sum, 1.0);
}
