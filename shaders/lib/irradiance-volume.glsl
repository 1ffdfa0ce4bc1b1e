// Irradiance volume: indirect light anywhere in the room, for 1 cd of the flame's, from a grid of probes.
// MOONLIT: needs lib/moon.glsl.
//
// Planes of probes of constant z lie one above another. Each probe is a tile of `uIrradiance`, an octahedral map of
// irradiance, lx, by surface normal. A probe is weighted by distance, by the surface's normal, and by its visibility:
// Majercik, Guertin, Nowrouzezahrai and McGuire 2019, "Dynamic Diffuse Global Illumination with Ray-Traced Irradiance
// Fields".
#include "lib/octahedral.glsl"

layout(std140) uniform Volume {
  vec3 corner;    // of the room, along its axes, m
  float planes;   // probes along z
  vec3 extent;    // of the room, m
  float columns;  // probes along x
  float rows;     // probes along y
  float inset;    // distance of the outermost probes from the bounds, cells
  float bias;     // of a surface's distance to the probes, along its normal, m
  vec2 axis;      // cosine and sine of the angle from the world's axes to the room's
} volume;

uniform sampler2D uIrradiance;
uniform sampler2D uProbePositions;  // m; 1, or 0 for a probe inside a solid
uniform sampler2D uProbeDepth;  // mean and standard deviation of the distance along a direction, m: octahedral maps

// Edges of the tiles, texels, and of their maps within them: src/render/gi/probe-rays.ts. Maps of depth have a border;
// those of irradiance have a texel on each axis, so that walls along them are exact, and end in the middle of texels.
const vec2 PROBE_DEPTH_EDGE = vec2(18.0, 16.0);
const vec2 IRRADIANCE_EDGE = vec2(7.0, 6.0);

// From uv on a probe's map to uv on the atlas.
vec2 atlasUv(ivec2 tile, vec2 edge, vec2 uv) {
  vec2 tiles = vec2(volume.columns, volume.rows * volume.planes);
  return (vec2(tile) + 0.5 + (uv - 0.5) * (edge.y / edge.x)) / tiles;
}

// `direction`: of any length. A unit vector would keep the fetch waiting.
vec2 probeDepth(ivec2 tile, vec3 direction) {
  return textureLod(uProbeDepth, atlasUv(tile, PROBE_DEPTH_EDGE, octahedralEncode(direction)), 0.0).rg;
}

// Chebyshev's upper bound of the share that is visible at `reach` (m), by mean and deviation of the depth.
float probeVisibility(vec2 depth, float reach) {
  float beyond = max(reach - depth.r, 0.0);
  float variance = max(depth.g * depth.g, 1e-3);
  return variance / (variance + beyond * beyond);
}

// Corners of a tetrahedron, and of the whole cell.
#ifndef VOLUME_TAPS
#define VOLUME_TAPS 12
#endif

// Weight of a tetrahedron's probes below which those of its cell take part: they are behind a corner, or the surface.
const float SEEN = 0.1;

// Irradiance at one point by two normals, lx: the surface's, and its mirrored view ray.
struct IrradianceSample {
  vec3 alongNormal;
  vec3 alongReflection;
  float moonlight;  // MOONLIT: along the normal, for 1 lx, by the weights of its luma
};

#ifdef MOONLIT
uniform sampler2D uMoonIrradiance;
#endif

// Tile of a probe, by its place in the grid.
ivec2 tileAt(vec3 probe) {
  return ivec2(int(probe.x), int(probe.z * volume.rows + probe.y));
}

vec3 probeIrradiance(ivec2 tile, vec2 uv) {
  return textureLod(uIrradiance, atlasUv(tile, IRRADIANCE_EDGE, uv), 0.0).rgb;
}

// Cell of the grid at a point: its lowest probe, and the point's place between its probes.
struct VolumeCell {
  vec3 low;
  vec3 share;
};

VolumeCell volumeCellAt(vec3 position) {
  vec3 count = vec3(volume.columns, volume.rows, volume.planes);
  vec3 cells = count - 1.0 + 2.0 * volume.inset;
  mat2 toRoom = mat2(volume.axis.x, volume.axis.y, -volume.axis.y, volume.axis.x);
  position.xz = toRoom * position.xz;
  vec3 place = clamp((position - volume.corner) / volume.extent * cells - volume.inset, vec3(0.0), count - 1.001);
  return VolumeCell(floor(place), fract(place));
}

// The tetrahedron that a point of a cell lies in, one of the six along a diagonal: Kuhn 1960, "Some Combinatorial Lemmas
// in Topology". Neighbouring cells are mirror images, so that tetrahedra meet face to face. Half the taps of trilinear
// interpolation, and as continuous.
struct Tetrahedron {
  vec3 ranks;      // of the axes, by the point's distance along each from where the diagonal starts: the four corners follow
                   // them in turn; negative for an axis along which it starts at 1
  vec3 distances;  // the longest first
};

Tetrahedron tetrahedronAt(VolumeCell cell) {
  vec3 start = mod(cell.low, 2.0);
  vec3 s = abs(start - cell.share);
  vec3 ranks = 1.0 + vec3(greaterThan(s.yxx, s.xyz)) + vec3(greaterThan(s.zzy, s.xyz));
  ranks.yz += vec2(equal(s.yz, s.xx));
  ranks.z += s.z == s.y ? 1.0 : 0.0;
  float most = max(s.x, max(s.y, s.z));
  float least = min(s.x, min(s.y, s.z));
  return Tetrahedron(ranks * (1.0 - 2.0 * start), vec3(most, s.x + s.y + s.z - most - least, least));
}

// A corner, from the lowest one of its cell.
vec3 cornerOf(Tetrahedron tetrahedron, int corner) {
  return abs(step(tetrahedron.ranks, vec3(0.0)) - step(abs(tetrahedron.ranks), vec3(corner)));
}

vec3 cornerOf(int corner) {
  return vec3(corner & 1, (corner >> 1) & 1, corner >> 2);
}

// Barycentric coordinate of a corner.
float shareOf(Tetrahedron tetrahedron, int corner) {
  vec4 shares = vec4(1.0, tetrahedron.distances) - vec4(tetrahedron.distances, 0.0);
  return dot(shares, vec4(equal(ivec4(corner), ivec4(0, 1, 2, 3))));
}

float shareOf(VolumeCell cell, vec3 corner) {
  vec3 shares = mix(1.0 - cell.share, cell.share, corner);
  return shares.x * shares.y * shares.z;
}

// Weight of a probe at a point. `share`: by place; `facing`: normal by which probes are weighted, or 0 in mid-air;
// `offset`: of the point along it, m.
float probeWeight(ivec2 tile, float share, vec3 position, vec3 facing, float offset) {
  vec4 probe = texelFetch(uProbePositions, tile, 0);
  vec3 fromProbe = position - probe.xyz + facing * offset;
  float wrapped = 0.5 - 0.5 * dot(fromProbe, facing) * inversesqrt(max(dot(fromProbe, fromProbe), 1e-8));
  vec3 toBiased = fromProbe + facing * volume.bias;
  float biasedReach = max(length(toBiased), 1e-4);
  float visibility = probeVisibility(probeDepth(tile, toBiased), biasedReach);
  float weight = max(share, 1e-4) * (wrapped * wrapped + 0.04);
  return weight * probe.w * max(visibility * visibility * visibility, 1e-6);
}

// `facing`: normal by which probes are weighted, or 0 in mid-air; `offset`: of the point along it, m.
IrradianceSample irradianceAt(vec3 position, float offset, vec3 facing, vec3 normal, vec3 reflection) {
  VolumeCell cell = volumeCellAt(position + facing * offset);
  Tetrahedron tetrahedron = tetrahedronAt(cell);
  vec2 normalUv = octahedralEncode(normal);
  vec2 reflectionUv = octahedralEncode(reflection);
  IrradianceSample sum = IrradianceSample(vec3(0.0), vec3(0.0), 0.0);
  float total = 0.0;
  float shareOfCell = 0.0;
  for (int i = 0; i < VOLUME_TAPS; i++) {
    if (i == 4) shareOfCell = 1.0 - total / SEEN;
    if (i >= 4 && shareOfCell <= 0.0) break;
    vec3 corner = i < 4 ? cornerOf(tetrahedron, i) : cornerOf(i - 4);
    float share = i < 4 ? shareOf(tetrahedron, i) : shareOfCell * shareOf(cell, corner);
    ivec2 tile = tileAt(cell.low + corner);
    float weight = probeWeight(tile, share, position, facing, offset);
    sum.alongReflection += weight * probeIrradiance(tile, reflectionUv);
    sum.alongNormal += weight * probeIrradiance(tile, normalUv);
#ifdef MOONLIT
    vec2 uv = atlasUv(tile, IRRADIANCE_EDGE, normalUv);
    sum.moonlight += weight * moonLuma(textureLod(uMoonIrradiance, uv, 0.0).rgb);
#endif
    total += weight;
  }
  float scale = 1.0 / max(total, 1e-12);
  return IrradianceSample(sum.alongNormal * scale, sum.alongReflection * scale, sum.moonlight * scale);
}
