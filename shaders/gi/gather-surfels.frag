#version 300 es
// First bounce at each probe: radiance of all surfels, by their visibility and their weight against the rays.
// Out: spherical harmonics of radiance, cd/m².
#include "lib/precision.glsl"
#include "lib/octahedral.glsl"
#include "lib/photometry.glsl"
#include "lib/sh.glsl"
#include "lib/flame-light.glsl"
#include "lib/probe-rays.glsl"
#include "lib/surfels.glsl"

uniform sampler2D uProbePositions;  // m
uniform sampler2D uRadiosity;       // of the surfels, lm/m²

layout(location = 0) out vec4 oSh0;
layout(location = 1) out vec4 oSh1;
layout(location = 2) out vec4 oSh2;

// Visible share of a point at `reach` (m) along a direction, from the hits of the four rays around it.
float surfelVisibility(ivec2 tile, vec3 direction, float reach) {
  vec2 place = octahedralEncode(direction) * float(RAYS) - 0.5;
  vec2 cell = floor(place);
  float visible = 0.0;
  float total = 1e-6;
  for (int i = 0; i < 4; i++) {
    vec2 corner = vec2(i & 1, i >> 1);
    vec2 shares = mix(1.0 - (place - cell), place - cell, corner);
    vec2 texel = clamp(cell + corner, vec2(0.0), vec2(RAYS - 1));
    vec4 hit = texelFetch(uRayHits, tile * RAYS + ivec2(texel), 0);
    vec3 ray = normalize(octahedralDecode((texel + 0.5) / float(RAYS)));
    float weight = hit.w > 0.0 ? shares.x * shares.y : 0.0;
    visible += isVisiblePast(ray * hit.w, hit.xyz, direction, reach) ? weight : 0.0;
    total += weight;
  }
  return visible / total;
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  ivec2 tile = ivec2(texel.x / SH_TEXELS, texel.y);
  int k = texel.x - tile.x * SH_TEXELS;
  vec3 position = texelFetch(uProbePositions, tile, 0).xyz;
  int size = textureSize(uSurfelNormalDistance, 0).y;
  ShTexel sum = ShTexel(vec3(0.0), vec3(0.0), vec3(0.0));
  for (int y = 0; y < size; y++) {
    for (int x = 0; x < FACE_COUNT * size; x++) {
      Surfel surfel = surfelAt(ivec2(x, y), size);
      vec3 toSurfel = surfel.position - position;
      float distanceSquared = max(dot(toSurfel, toSurfel), 1e-6);
      float reach = sqrt(distanceSquared);
      vec3 direction = toSurfel / reach;
      float cosine = dot(surfel.normal, -direction);
      if (cosine <= 0.0 || surfel.distance <= 0.0) continue;
      float solidAngle = cosine * surfel.area / distanceSquared;
      solidAngle *= 1.0 - rayWeight(solidAngle, raySolidAngle(direction / dot(abs(direction), vec3(1.0))));
      float visibility = surfelVisibility(tile, direction, reach);
      addRadiance(sum, k, direction, texelFetch(uRadiosity, ivec2(x, y), 0).rgb * (solidAngle * visibility / PI));
    }
  }
  oSh0 = vec4(sum.first, 1.0);
  oSh1 = vec4(sum.second, 1.0);
  oSh2 = vec4(sum.third, 1.0);
}
