#version 300 es
// A coarser irradiance volume at the probes of a finer one.
// In:  a volume, places of probes.   Out: lx, octahedral maps of IRRADIANCE_TEXELS along an edge, as gi/gather's.
#include "lib/precision.glsl"
#include "lib/irradiance-volume.glsl"

uniform sampler2D uFinePositions;  // m

out vec4 oIrradiance;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  ivec2 tile = texel / IRRADIANCE_TEXELS;
  vec3 normal = normalize(octahedralDecode(vec2(texel - tile * IRRADIANCE_TEXELS) / float(IRRADIANCE_TEXELS - 1)));
  vec3 position = texelFetch(uFinePositions, tile, 0).xyz;
  oIrradiance = vec4(irradianceAt(position, 0.0, vec3(0.0), normal, normal).alongNormal, 1.0);
}
