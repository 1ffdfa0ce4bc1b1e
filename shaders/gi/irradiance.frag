#version 300 es
// Convolves each probe's radiance with the cosine lobe, onto its tile of the irradiance atlas, border included.
// In: spherical harmonics of radiance, cd/m².   Out: lx.
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
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec2 tile = pixel / int(IRRADIANCE_EDGE);
  vec2 uv = (vec2(pixel - tile * int(IRRADIANCE_EDGE)) + 0.5 - BORDER) / (IRRADIANCE_EDGE - 2.0 * BORDER);
  vec3 normal = normalize(octahedralDecode(uv));
  vec3 sum = vec3(0.0);
  for (int k = 0; k < SH_TEXELS; k++) {
    ivec2 texel = ivec2(tile.x * SH_TEXELS + k, tile.y);
    sum += cosineLobe(k) * shBasis(k, normal) * texelFetch(uSh0, texel, 0).rgb;
    sum += cosineLobe(k + 3) * shBasis(k + 3, normal) * texelFetch(uSh1, texel, 0).rgb;
    sum += cosineLobe(k + 6) * shBasis(k + 6, normal) * texelFetch(uSh2, texel, 0).rgb;
  }
  oIrradiance = vec4(max(sum, 0.0), 1.0);
}
