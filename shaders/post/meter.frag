#version 300 es
// Light metering of each cell of the frame, the flame excluded.
// In:  radiance, cd/m²; PER_CANDELA: for each candela; DEFERRED: G-buffer, light.
// Out: red: mean of weighted log2 luminance; green: of the weight.
#include "lib/precision.glsl"
#include "lib/photometry.glsl"
#if defined(DEFERRED) || defined(PER_CANDELA)
#include "lib/flame-light.glsl"
#endif
#ifdef DEFERRED
#include "lib/composite.glsl"
#else
uniform sampler2D uRadiance;
#endif

vec3 radianceAt(vec2 uv) {
#ifdef DEFERRED
  return compositeRadiance(texelFetch(uGBufferAlbedo, ivec2(uv * vec2(textureSize(uGBufferAlbedo, 0))), 0), uv);
#else
  vec3 radiance = texelFetch(uRadiance, ivec2(uv * vec2(textureSize(uRadiance, 0))), 0).rgb;
#ifdef PER_CANDELA
  radiance *= light.intensity;
#endif
  return radiance;
#endif
}

#include "lib/metering.glsl"

in vec2 vUv;

out vec4 oLogLuminance;

void main() {
  vec2 cell = floor(gl_FragCoord.xy);
  oLogLuminance = vec4(meterCell(cell, gl_FragCoord.xy / vUv), 0.0, 1.0);
}
