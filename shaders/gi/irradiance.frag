#version 300 es
// Irradiance at each probe, by the way that a surface faces: a tile of an octahedral map, with its seam.
// Out: lx.
#include "lib/precision.glsl"
#include "lib/octahedral.glsl"
#include "lib/photometry.glsl"
#include "lib/sh.glsl"
#include "lib/irradiance-volume.glsl"

uniform sampler2D uSh0;
uniform sampler2D uSh1;
uniform sampler2D uSh2;

out vec4 oIrradiance;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  ivec2 tile = texel / int(LIT);
  vec2 place = (vec2(texel - tile * int(LIT)) + 0.5 - SEAM) / (LIT - 2.0 * SEAM);
  vec3 normal = normalize(octahedralDecode(place));
  vec3 sum = vec3(0.0);
  for (int k = 0; k < TILE; k++) {
    ivec2 texel = ivec2(tile.x * TILE + k, tile.y);
    sum += kept(k) * shBasis(k, normal) * texelFetch(uSh0, texel, 0).rgb;
    sum += kept(k + 3) * shBasis(k + 3, normal) * texelFetch(uSh1, texel, 0).rgb;
    sum += kept(k + 6) * shBasis(k + 6, normal) * texelFetch(uSh2, texel, 0).rgb;
  }
  oIrradiance = vec4(max(sum, 0.0), 1.0);
}
