#version 300 es
// Two of the eight probes around each hit of the probes' rays, for the irradiance there. They do not depend on the light.
// Out: tile of the one, and of the other, x and y / 255.
//
// Each probe is taken as often as its weight asks, by systematic sampling along the sum of the weights: the mean over
// rays is that of all eight, for a quarter of the taps. They share its light trilinearly, in grids as coarse as those of `low`.
#include "lib/precision.glsl"
#include "lib/probe-rays.glsl"
#include "lib/irradiance-volume.glsl"

// Of the plane-filling sequence R2: Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences".
const vec2 R2 = vec2(0.7548777, 0.5698403);

layout(location = 0) out vec4 oTiles;

void main() {
  ProbeRay ray = probeRayAt(ivec2(gl_FragCoord.xy));
  vec3 position = hitPosition(ray, texelFetch(uProbePositions, ray.tile, 0).xyz);
  VolumeCell cell = volumeCellAt(position);
  float weights[8];
  float total = 1e-12;
  for (int i = 0; i < 8; i++) {
    vec3 corner = cornerOf(i);
    weights[i] = probeWeight(tileAt(cell.low + corner), shareOf(cell, corner), position, ray.normal, 0.0);
    total += weights[i];
  }
  float first = 0.5 * total * fract(dot(vec2(ray.texel), R2));
  float second = first + 0.5 * total;
  float sum = 0.0;
  oTiles = vec4(0.0);
  for (int i = 0; i < 8; i++) {
    vec2 tile = vec2(tileAt(cell.low + cornerOf(i))) / 255.0;
    if (sum <= first) oTiles.xy = tile;
    if (sum <= second) oTiles.zw = tile;
    sum += weights[i];
  }
}
