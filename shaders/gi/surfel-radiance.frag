#version 300 es
// First bounce: radiance of a group of surfels as one, as each probe receives it, by its visibility and its weight
// against the rays. MOON: visibility was traced, by the texel of each group that each probe takes.
// Out: radiance times solid angle, cd/m² sr; direction. A probe's tile is as wide as its map of rays.
#include "lib/precision.glsl"
#include "lib/octahedral.glsl"
#include "lib/probe-rays.glsl"
#include "lib/random.glsl"
#ifdef MOON
#include "lib/moon.glsl"
#else
#include "lib/flame-light.glsl"
#endif
#include "lib/surfels.glsl"
#include "lib/glossy-lobe.glsl"

uniform sampler2D uProbePositions;  // m
uniform sampler2D uRadiosity;       // of the surfels, lm/m²; gloss
#ifdef MOON
uniform sampler2D uSurfelVisibility;  // 1 or 0, in the tiles of the output
#endif

layout(location = 0) out vec4 oRadiance;
layout(location = 1) out vec4 oDirection;

#ifndef MOON
// A hit this far behind the plane of another lies on its front, m.
const float COPLANAR = 0.02;
// So many times as far as the farthest of four hits a point may be.
const float FARTHER = 1.15;

// Visibility of a point at `reach` (m) along a direction, past the surface that a nearby ray from the same origin hit:
// up to the plane of that surface, or three times as far along a plane that it never meets. The tolerance is a share of
// the distance, and metres.
bool isVisiblePast(vec3 hit, vec3 normal, vec3 direction, float reach) {
  float cosine = dot(normal, direction);
  float end = cosine < -1e-3 ? max(length(hit), dot(normal, hit) / cosine) : 3.0 * length(hit);
  return reach <= end + 0.03 * reach + 0.02;
}

// A texel of the octahedral map of rays; beyond an edge the one that meets it there, across the seam.
vec2 wrapped(vec2 texel) {
  float last = float(uRays - 1);
  if (texel.x < 0.0 || texel.x > last) texel = vec2(clamp(texel.x, 0.0, last), last - texel.y);
  if (texel.y < 0.0 || texel.y > last) texel = vec2(last - texel.x, clamp(texel.y, 0.0, last));
  return texel;
}

// Visible share of a point at `reach` (m) along a direction, from the hits of the four rays around it. Where two hits
// lie in front of each other's planes, the surfaces meet in a concave edge, and the nearer one hides what is behind
// both.
float surfelVisibility(ivec2 tile, vec3 direction, float reach) {
  vec3 turn = turnOf(tile);
  vec2 place = octahedralEncode(turnedBack(direction, turn)) * float(uRays) - 0.5;
  vec2 cell = floor(place);
  vec3 hits[4];
  vec3 normals[4];
  vec4 weights;
  bvec4 isVisible;
  for (int i = 0; i < 4; i++) {
    vec2 corner = vec2(i & 1, i >> 1);
    vec2 shares = mix(1.0 - (place - cell), place - cell, corner);
    vec2 texel = wrapped(cell + corner);
    vec4 hit = texelFetch(uRayHits, tile * uRays + ivec2(texel), 0);
    hits[i] = turned(normalize(octahedralDecode((texel + 0.5) / float(uRays))), turn) * hit.w;
    normals[i] = hit.xyz;
    weights[i] = hit.w > 0.0 ? shares.x * shares.y : 0.0;
    isVisible[i] = isVisiblePast(hits[i], normals[i], direction, reach);
  }
  // What lies farther than all four is behind something that none of them hit, or at the end of a plane that one grazes.
  float farthest = max(max(length(hits[0]), length(hits[1])), max(length(hits[2]), length(hits[3])));
  if (reach > FARTHER * farthest) return 0.0;
  float visible = 0.0;
  for (int i = 0; i < 4; i++) {
    bool isHidden = !isVisible[i];
    for (int j = 0; j < 4; j++) {
      isHidden = isHidden || (!isVisible[j] && weights[j] > 0.0 && dot(hits[i] - hits[j], normals[j]) > -COPLANAR);
    }
    visible += isHidden ? 0.0 : weights[i];
  }
  return visible / (dot(weights, vec4(1.0)) + 1e-6);
}
#endif

void main() {
  oRadiance = oDirection = vec4(0.0, 0.0, 0.0, 1.0);
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec2 tile = quotient(pixel, ivec2(uRays, uSurfelRows));
  ivec2 place = pixel - tile * ivec2(uRays, uSurfelRows);
  int size = textureSize(uSurfelNormalDistance, 0).y;
  ivec2 group = surfelOfIndex(place.y * uRays + place.x, size / uGroup);
  if (group.y >= size / uGroup) return;
  // Each probe takes another one of the group, so that their errors differ and interpolation averages them.
  uint chance = pcg(uint(group.x + 8192 * group.y) + pcg(uint(tile.x + 8192 * tile.y)));
  ivec2 texel = group * uGroup + ivec2((chance >> 8) & 4095u, chance >> 20) % uGroup;
  Surfel surfel = surfelAt(texel, size);
  vec3 toSurfel = surfel.position - texelFetch(uProbePositions, tile, 0).xyz;
  float distanceSquared = max(dot(toSurfel, toSurfel), 1e-6);
  float reach = sqrt(distanceSquared);
  vec3 direction = toSurfel / reach;
  float cosine = dot(surfel.normal, -direction);
  if (cosine <= 0.0 || surfel.distance <= 0.0) return;
  float solidAngle = cosine * surfel.area * float(uGroup * uGroup) / distanceSquared;
  vec3 unturned = turnedBack(direction, turnOf(tile));
  solidAngle *= 1.0 - rayWeight(solidAngle, raySolidAngle(unturned / dot(abs(unturned), vec3(1.0))));
#ifdef MOON
  float visibility = texelFetch(uSurfelVisibility, pixel, 0).r;
  vec3 toLight = -moon.direction;
  if (isPaneSurfel(texel, size)) solidAngle *= paneShare(direction);
#else
  float visibility = surfelVisibility(tile, direction, reach);
  vec3 toLight = normalize(light.captureOrigin - surfel.position);
#endif
  vec4 radiosity = texelFetch(uRadiosity, texel, 0);
  oDirection.xyz = direction;
  oRadiance.rgb = radiosity.rgb * (solidAngle * visibility * glossyLobe(radiosity.a, surfel.normal, toLight, -direction));
}
