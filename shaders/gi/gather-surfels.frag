#version 300 es
// What each probe gets of the light that bounces for the first time: all patches that the flame sees, as
// far as the probe sees them and its rays do not tell more.
// Out: three coefficients of radiance.
#include "lib/precision.glsl"
#include "lib/octahedral.glsl"
#include "lib/photometry.glsl"
#include "lib/sh.glsl"
#include "lib/flame-light.glsl"
#include "lib/probe-rays.glsl"
#include "lib/surfels.glsl"

uniform sampler2D uProbePositions;  // place of each, m
uniform sampler2D uRadiosity;

layout(location = 0) out vec4 oSh0;
layout(location = 1) out vec4 oSh1;
layout(location = 2) out vec4 oSh2;

// Share of the four rays around a direction that end no nearer than `reach`, m.
float seenAt(ivec2 tile, vec3 direction, float reach) {
  vec2 place = octahedralEncode(direction) * float(RAYS) - 0.5;
  vec2 cell = floor(place);
  float seen = 0.0;
  float total = 1e-6;
  for (int corner = 0; corner < 4; corner++) {
    vec2 step = vec2(corner & 1, corner >> 1);
    vec2 shares = mix(1.0 - (place - cell), place - cell, step);
    vec2 texel = clamp(cell + step, vec2(0.0), vec2(RAYS - 1));
    vec4 hit = texelFetch(uRayHits, tile * RAYS + ivec2(texel), 0);
    vec3 ray = normalize(octahedralDecode((texel + 0.5) / float(RAYS)));
    float share = hit.w > 0.0 ? shares.x * shares.y : 0.0;
    seen += isVisiblePast(ray * hit.w, hit.xyz, direction, reach) ? share : 0.0;
    total += share;
  }
  return seen / total;
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  ivec2 tile = ivec2(texel.x / TILE, texel.y);
  int k = texel.x - tile.x * TILE;
  vec3 position = texelFetch(uProbePositions, tile, 0).xyz;
  int size = textureSize(uSurfelNormalDistance, 0).y;
  vec3 first = vec3(0.0);
  vec3 second = vec3(0.0);
  vec3 third = vec3(0.0);
  for (int y = 0; y < size; y++) {
    for (int x = 0; x < FACE_COUNT * size; x++) {
      Surfel surfel = surfelAt(ivec2(x, y), size);
      vec3 toward = surfel.position - position;
      float distanceSquared = max(dot(toward, toward), 1e-6);
      float reach = sqrt(distanceSquared);
      vec3 direction = toward / reach;
      float facing = dot(surfel.normal, -direction);
      if (facing <= 0.0 || surfel.distance <= 0.0) continue;
      float solidAngle = facing * surfel.area / distanceSquared;
      solidAngle *= 1.0 - rayWeight(solidAngle, raySolidAngle(direction / dot(abs(direction), vec3(1.0))));
      float seen = seenAt(tile, direction, reach);
      vec3 light = texelFetch(uRadiosity, ivec2(x, y), 0).rgb * (solidAngle * seen / PI);
      first += shBasis(k, direction) * light;
      second += shBasis(k + 3, direction) * light;
      third += shBasis(k + 6, direction) * light;
    }
  }
  oSh0 = vec4(first, 1.0);
  oSh1 = vec4(second, 1.0);
  oSh2 = vec4(third, 1.0);
}
