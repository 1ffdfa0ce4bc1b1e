#version 300 es
// Mean reflectance of the room at the hits of its probes' rays.
// Out: red, luma; rays that hit nothing count as black.
#include "lib/precision.glsl"
#include "lib/photometry.glsl"
#include "lib/probe-rays.glsl"

uniform sampler2D uRayReflectance;
uniform sampler2D uProbePositions;  // alpha: 1, or 0 for a probe inside a solid

out vec4 oReflectance;

const int PROBES = 64;
const int STRIDE = 37;  // prime, so that the sample is spread

void main() {
  ivec2 tiles = textureSize(uProbePositions, 0);
  int count = tiles.x * tiles.y;
  float sum = 0.0;
  float total = 1e-6;
  for (int i = 0; i < PROBES; i++) {
    int probe = (i * STRIDE) % count;
    ivec2 tile = ivec2(probe % tiles.x, probe / tiles.x);
    float isOutside = texelFetch(uProbePositions, tile, 0).a;
    for (int y = 0; y < uRays; y += 2) {
      for (int x = 0; x < uRays; x += 2) {
        ProbeRay ray = probeRayAt(tile * uRays + ivec2(x, y));
        float reflectance = ray.reach > 0.0 ? luma(texelFetch(uRayReflectance, ray.texel, 0).rgb) : 0.0;
        sum += isOutside * ray.solidAngle * reflectance;
        total += isOutside * ray.solidAngle;
      }
    }
  }
  oReflectance = vec4(sum / total, 0.0, 0.0, 1.0);
}
