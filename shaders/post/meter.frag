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

// Taps along an edge of a cell.
const int TAPS = 4;
const float DARKEST = 1e-4;  // cd/m²: as in src/world/player/exposure-adaptation.ts
// Logarithms of luminance between which the weight falls to 0: only the flame and its mirror images are beyond.
const float SURFACE = 6.0;
const float FLAME = 9.0;

// Mean of weighted log2 luminance, and of the weight. `cells`: number of cells.
vec2 meterCell(vec2 cell, vec2 cells) {
  float sum = 0.0;
  float weights = 0.0;
  for (int i = 0; i < TAPS * TAPS; i++) {
    vec2 tap = (vec2(i % TAPS, i / TAPS) + 0.5) / float(TAPS);
    float logLuminance = log2(max(luma(radianceAt((cell + tap) / cells)), DARKEST));
    float weight = 1.0 - smoothstep(SURFACE, FLAME, logLuminance);
    sum += logLuminance * weight;
    weights += weight;
  }
  return vec2(sum, weights) / float(TAPS * TAPS);
}

in vec2 vUv;

out vec4 oLogLuminance;

void main() {
  vec2 cell = floor(gl_FragCoord.xy);
  oLogLuminance = vec4(meterCell(cell, gl_FragCoord.xy / vUv), 0.0, 1.0);
}
