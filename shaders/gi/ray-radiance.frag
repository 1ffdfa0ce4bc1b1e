#version 300 es
// What probes see of the light that has bounced before: the volume's, thrown back where each ray ends.
// Out: radiance of what each ray meets, cd/m².
#include "lib/precision.glsl"
#include "lib/octahedral.glsl"
#include "lib/photometry.glsl"
#include "lib/probe-rays.glsl"
#include "lib/irradiance-volume.glsl"

uniform sampler2D uRayAlbedo;  // base colour

// A surface is lit by the probes before it: how far before, m.
const float LIFT = 0.03;

out vec4 oRadiance;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  ivec2 tile = texel / RAYS;
  vec4 hit = texelFetch(uRayHits, texel, 0);
  vec3 direction = normalize(octahedralDecode((vec2(texel - tile * RAYS) + 0.5) / float(RAYS)));
  vec3 position = texelFetch(uProbePositions, tile, 0).xyz + direction * hit.w + hit.xyz * LIFT;
  vec3 irradiance = irradianceAt(position, hit.xyz, hit.xyz, hit.xyz).one;
  oRadiance = vec4(hit.w > 0.0 ? reflected(texelFetch(uRayAlbedo, texel, 0).rgb) * irradiance / PI : vec3(0.0), 1.0);
}
