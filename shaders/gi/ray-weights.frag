#version 300 es
// Weights by which the hits of the probes' rays interpolate the irradiance volume. They do not depend on the light.
// Out: of the eight probes around each hit.
#include "lib/precision.glsl"
#include "lib/octahedral.glsl"
#include "lib/photometry.glsl"
#include "lib/probe-rays.glsl"
#include "lib/irradiance-volume.glsl"

layout(location = 0) out vec4 oNear;
layout(location = 1) out vec4 oFar;

void main() {
  ProbeRay ray = probeRayAt(ivec2(gl_FragCoord.xy));
  vec3 position = hitPosition(ray, texelFetch(uProbePositions, ray.tile, 0).xyz);
  VolumeCell cell = volumeCellAt(position);
  float weights[8];
  float total = 1e-12;
  for (int i = 0; i < 8; i++) {
    weights[i] = probeWeight(cell, volumeCorner(i), position, ray.normal);
    total += weights[i];
  }
  oNear = vec4(weights[0], weights[1], weights[2], weights[3]) / total;
  oFar = vec4(weights[4], weights[5], weights[6], weights[7]) / total;
}
