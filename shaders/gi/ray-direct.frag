#version 300 es
// First bounce at the hits of the probes' rays: direct light, by the weight of the rays against the surfels.
// Out: radiance, cd/m².
#include "lib/precision.glsl"
#include "lib/octahedral.glsl"
#include "lib/photometry.glsl"
#include "lib/flame-light.glsl"
#include "lib/probe-rays.glsl"
#include "lib/surfels.glsl"

uniform sampler2D uProbePositions;  // m
uniform sampler2D uRayAlbedo;

out vec4 oRadiance;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  ivec2 tile = texel / RAYS;
  vec4 hit = texelFetch(uRayHits, texel, 0);
  vec3 onOctahedron = octahedralDecode((vec2(texel - tile * RAYS) + 0.5) / float(RAYS));
  vec3 direction = normalize(onOctahedron);
  vec3 position = texelFetch(uProbePositions, tile, 0).xyz + direction * hit.w;
  vec3 fromLight = position - light.captureOrigin;
  float distanceSquared = dot(fromLight, fromLight);
  float reach = sqrt(distanceSquared);
  vec3 lightDirection = fromLight / reach;
  float NoL = dot(hit.xyz, -lightDirection);
  int size = textureSize(uSurfelNormalDistance, 0).y;
  Surfel surfel = surfelAt(surfelTexel(lightDirection, size), size);
  oRadiance = vec4(0.0, 0.0, 0.0, 1.0);
  if (hit.w <= 0.0 || NoL <= 0.0) return;
  if (!isVisiblePast(surfel.position - light.captureOrigin, surfel.normal, lightDirection, reach)) return;
  // Of a surfel at the hit, from the probe.
  float area = surfel.solidAngle * distanceSquared / limitedCosine(NoL);
  float surfelSolidAngle = max(dot(hit.xyz, -direction), 0.0) * area / (hit.w * hit.w);
  vec3 irradiance = light.intensity * (NoL / distanceSquared * candleVisibility(position));
  vec3 radiance = hemisphericalReflectance(texelFetch(uRayAlbedo, texel, 0).rgb) * irradiance / PI;
  oRadiance.rgb = radiance * rayWeight(surfelSolidAngle, raySolidAngle(onOctahedron));
}
