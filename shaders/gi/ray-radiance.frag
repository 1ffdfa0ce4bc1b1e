#version 300 es
// Next bounce at the hits of the probes' rays: the irradiance volume's light, reflected.
// Out: radiance, cd/m².
#include "lib/precision.glsl"
#include "lib/octahedral.glsl"
#include "lib/photometry.glsl"
#include "lib/probe-rays.glsl"
#include "lib/irradiance-volume.glsl"

uniform sampler2D uRayAlbedo;

// The volume is sampled this far in front of the surface, m.
const float NORMAL_OFFSET = 0.03;

out vec4 oRadiance;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  ivec2 tile = texel / RAYS;
  vec4 hit = texelFetch(uRayHits, texel, 0);
  vec3 direction = normalize(octahedralDecode((vec2(texel - tile * RAYS) + 0.5) / float(RAYS)));
  vec3 position = texelFetch(uProbePositions, tile, 0).xyz + direction * hit.w + hit.xyz * NORMAL_OFFSET;
  vec3 irradiance = irradianceAt(position, hit.xyz, hit.xyz, hit.xyz).alongNormal;
  vec3 reflectance = hemisphericalReflectance(texelFetch(uRayAlbedo, texel, 0).rgb);
  oRadiance = vec4(hit.w > 0.0 ? reflectance * irradiance / PI : vec3(0.0), 1.0);
}
