#version 300 es
// What the probes' rays see of the flame's own light, as far as patches do not tell more.
// Out: radiance of what each ray meets, cd/m².
#include "lib/precision.glsl"
#include "lib/octahedral.glsl"
#include "lib/photometry.glsl"
#include "lib/flame-light.glsl"
#include "lib/probe-rays.glsl"
#include "lib/surfels.glsl"

uniform sampler2D uProbePositions;  // place of each, m
uniform sampler2D uRayAlbedo;    // base colour

out vec4 oRadiance;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  ivec2 tile = texel / RAYS;
  vec4 hit = texelFetch(uRayHits, texel, 0);
  vec3 onMap = octahedralDecode((vec2(texel - tile * RAYS) + 0.5) / float(RAYS));
  vec3 direction = normalize(onMap);
  vec3 position = texelFetch(uProbePositions, tile, 0).xyz + direction * hit.w;
  vec3 fromLight = position - light.vantage;
  float distanceSquared = dot(fromLight, fromLight);
  float reach = sqrt(distanceSquared);
  vec3 outward = fromLight / reach;
  float NoL = dot(hit.xyz, -outward);
  int size = textureSize(uSurfelNormalDistance, 0).y;
  Surfel surfel = surfelAt(surfelTexel(outward, size), size);
  oRadiance = vec4(0.0, 0.0, 0.0, 1.0);
  if (hit.w <= 0.0 || NoL <= 0.0) return;
  if (!isVisiblePast(surfel.position - light.vantage, surfel.normal, outward, reach)) return;
  // Of a patch here, as the probe would see it.
  float area = surfel.solidAngle * distanceSquared / slantOf(NoL);
  float patchAngle = max(dot(hit.xyz, -direction), 0.0) * area / (hit.w * hit.w);
  vec3 irradiance = light.intensity * (NoL / distanceSquared * candleVisibility(position));
  vec3 radiance = reflected(texelFetch(uRayAlbedo, texel, 0).rgb) * irradiance / PI;
  oRadiance.rgb = radiance * rayWeight(patchAngle, raySolidAngle(onMap));
}
