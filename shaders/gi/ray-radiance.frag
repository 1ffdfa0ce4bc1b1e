#version 300 es
// Next bounce at the hits of the probes' rays: the irradiance volume's light, reflected.
// Out: radiance times solid angle of four rays side by side, cd/m² sr.
#include "lib/precision.glsl"
#include "lib/octahedral.glsl"
#include "lib/photometry.glsl"
#include "lib/probe-rays.glsl"
#include "lib/irradiance-volume.glsl"

uniform sampler2D uRayReflectance;
uniform sampler2D uRayNearWeights;  // of the probes around a hit: gi/ray-weights.frag
uniform sampler2D uRayFarWeights;

out vec4 oRadiance;

void main() {
  vec3 sum = vec3(0.0);
  for (int n = 0; n < 4; n++) {
    ProbeRay ray = probeRayAt(2 * ivec2(gl_FragCoord.xy) + ivec2(n & 1, n >> 1));
    if (ray.reach <= 0.0) continue;
    VolumeCell cell = volumeCellAt(hitPosition(ray, texelFetch(uProbePositions, ray.tile, 0).xyz));
    vec2 uv = octahedralEncode(ray.normal);
    vec4 nearWeights = texelFetch(uRayNearWeights, ray.texel, 0);
    vec4 farWeights = texelFetch(uRayFarWeights, ray.texel, 0);
    vec3 irradiance = vec3(0.0);
    for (int i = 0; i < 8; i++) {
      float weight = i < 4 ? nearWeights[i] : farWeights[i - 4];
      if (weight > 0.0) irradiance += weight * probeIrradiance(tileAt(cell.low + volumeCorner(i)), uv);
    }
    sum += texelFetch(uRayReflectance, ray.texel, 0).rgb * irradiance * (ray.solidAngle / PI);
  }
  oRadiance = vec4(sum, 1.0);
}
