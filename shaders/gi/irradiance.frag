#version 300 es
// Convolves each probe's radiance with the cosine lobe, onto its tile of the irradiance atlas, border included.
// In: spherical harmonics of radiance, cd/m²; EXTRAPOLATED: after the last two bounces, and the tail of the series.
// Out: lx.
#include "lib/precision.glsl"
#include "lib/octahedral.glsl"
#include "lib/photometry.glsl"
#include "lib/sh.glsl"
#include "lib/irradiance-volume.glsl"

uniform sampler2D uSh0;
uniform sampler2D uSh1;
uniform sampler2D uSh2;
#if EXTRAPOLATED
uniform sampler2D uPreviousSh0;
uniform sampler2D uPreviousSh1;
uniform sampler2D uPreviousSh2;
uniform sampler2D uTail;  // gi/bounce-tail.frag
#endif

out vec4 oIrradiance;

#if EXTRAPOLATED
vec3 coefficient(sampler2D last, sampler2D previous, ivec2 texel) {
  vec3 sum = texelFetch(last, texel, 0).rgb;
  return sum + (sum - texelFetch(previous, texel, 0).rgb) * texelFetch(uTail, ivec2(0), 0).rgb;
}
#define COEFFICIENT(name, previous, texel) coefficient(name, previous, texel)
#else
#define COEFFICIENT(name, previous, texel) texelFetch(name, texel, 0).rgb
#endif

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec2 tile = pixel / int(IRRADIANCE_EDGE);
  vec2 uv = (vec2(pixel - tile * int(IRRADIANCE_EDGE)) + 0.5 - BORDER) / (IRRADIANCE_EDGE - 2.0 * BORDER);
  vec3 normal = normalize(octahedralDecode(uv));
  vec3 sum = vec3(0.0);
  for (int k = 0; k < SH_TEXELS; k++) {
    ivec2 texel = ivec2(tile.x * SH_TEXELS + k, tile.y);
    sum += cosineLobe(k) * shBasis(k, normal) * COEFFICIENT(uSh0, uPreviousSh0, texel);
    sum += cosineLobe(k + 3) * shBasis(k + 3, normal) * COEFFICIENT(uSh1, uPreviousSh1, texel);
    sum += cosineLobe(k + 6) * shBasis(k + 6, normal) * COEFFICIENT(uSh2, uPreviousSh2, texel);
  }
  oIrradiance = vec4(max(sum, 0.0), 1.0);
}
