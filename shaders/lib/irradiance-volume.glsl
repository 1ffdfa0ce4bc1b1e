// Light that comes from the room's surfaces, at every place, for 1 cd of the flame's.
// A grid of probes, flattened: planes of constant z lie side by side along x. Each is a tile of
// `uIrradiance`, an octahedral map of irradiance, lx, by the way that a surface faces.
// Needs lib/octahedral.glsl.
//
// After Majercik, Guertin, Nowrouzezahrai and McGuire 2019, "Dynamic Diffuse Global Illumination with
// Ray-Traced Irradiance Fields": a probe counts where it faces the surface and where it is in sight.

#include "lib/tetrahedron.glsl"

layout(std140) uniform Volume {
  vec3 corner;    // of the room, m
  float planes;   // probes along z
  vec3 extent;    // of the room, m
  float columns;  // probes along x
  float rows;     // probes along y
  float looks;    // 1: probes count where they are in sight; 0: where they are near
} volume;

uniform sampler2D uIrradiance;
uniform sampler2D uProbePositions;  // place of each, m; 1, or 0 for a probe that is buried
uniform sampler2D uProbeDepth;  // mean and deviation of the distance that each sees, m, tiles of octahedral maps

// Edges of the tiles, and the seam around what is inside of them: src/render/gi/probe-rays.ts.
const float SIGHT = 10.0;
const float LIT = 8.0;
const float SEAM = 1.0;

// Where a probe's map has a direction, on the texture of all tiles.
vec2 atlasUv(ivec2 tile, float edge, vec2 place) {
  vec2 tiles = vec2(volume.columns * volume.planes, volume.rows);
  return (vec2(tile) + (SEAM + place * (edge - 2.0 * SEAM)) / edge) / tiles;
}

// Mean and deviation of how far a probe sees in a direction, m.
vec2 sightOf(ivec2 tile, vec3 direction) {
  return textureLod(uProbeDepth, atlasUv(tile, SIGHT, octahedralEncode(direction)), 0.0).rg;
}

// Share of what is at `reach` (m) that has nothing before it, at most: Chebyshev's bound.
float probeVisibility(vec2 sight, float reach) {
  float beyond = max(reach - sight.r, 0.0);
  float variance = max(sight.g * sight.g, 1e-3);
  return variance / (variance + beyond * beyond);
}

// Irradiance of two surfaces that face two ways, lx.
struct IrradiancePair {
  vec3 one;
  vec3 other;
};

// The same of probes that only count by how near they are. They do not tell one way from another either, so
// there is one answer for both.
vec3 irradianceTetrahedral(vec3 cell, vec3 share, vec2 facing) {
  Tetrahedron tetrahedron = tetrahedronAt(share);
  vec3 sum = vec3(0.0);
  for (int corner = 0; corner < 4; corner++) {
    vec3 at = cell + cornerOf(tetrahedron, corner, share);
    ivec2 tile = ivec2(int(at.z * volume.columns + at.x), int(at.y));
    sum += tetrahedron.weights[corner] * textureLod(uIrradiance, atlasUv(tile, LIT, facing), 0.0).rgb;
  }
  return sum;
}

// For 1 cd of the flame's. `facing` is the normal of what is lit, or 0 in mid-air.
IrradiancePair irradianceAt(vec3 position, vec3 facing, vec3 one, vec3 other) {
  vec3 count = vec3(volume.columns, volume.rows, volume.planes);
  vec3 place = clamp((position - volume.corner) / volume.extent * count - 0.5, vec3(0.0), count - 1.001);
  vec3 cell = floor(place);
  vec3 share = place - cell;
  vec2 onOne = octahedralEncode(one);
  if (volume.looks < 0.5) {
    vec3 near = irradianceTetrahedral(cell, share, onOne);
    return IrradiancePair(near, near);
  }
  vec2 onOther = octahedralEncode(other);
  IrradiancePair sum = IrradiancePair(vec3(0.0), vec3(0.0));
  float total = 0.0;
  for (int corner = 0; corner < 8; corner++) {
    vec3 step = vec3(corner & 1, (corner >> 1) & 1, corner >> 2);
    vec3 at = cell + step;
    ivec2 tile = ivec2(int(at.z * volume.columns + at.x), int(at.y));
    vec3 shares = mix(1.0 - share, share, step);
    float weight = max(shares.x * shares.y * shares.z, 1e-4);
    vec4 probe = texelFetch(uProbePositions, tile, 0);
    vec3 away = position - probe.xyz;
    float reach = max(length(away), 1e-4);
    float turned = 0.5 - 0.5 * dot(away, facing) / reach;
    float seen = probeVisibility(sightOf(tile, away / reach), reach);
    weight *= probe.w * (turned * turned + 0.2) * max(seen * seen * seen, 1e-4);
    sum.other += weight * textureLod(uIrradiance, atlasUv(tile, LIT, onOther), 0.0).rgb;
    sum.one += weight * textureLod(uIrradiance, atlasUv(tile, LIT, onOne), 0.0).rgb;
    total += weight;
  }
  float scale = 1.0 / max(total, 1e-12);
  return IrradiancePair(sum.one * scale, sum.other * scale);
}
