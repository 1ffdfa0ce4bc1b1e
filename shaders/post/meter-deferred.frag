#version 300 es
// Light metering of each cell of the frame, the flame excluded.
// In:  G-buffer, light.   Out: red: mean of weighted log2 luminance; green: of the weight.
#include "lib/precision.glsl"
#include "lib/photometry.glsl"
#include "lib/flame-light.glsl"
#include "lib/gbuffer.glsl"
#include "lib/upsample-guided.glsl"
#include "lib/composite.glsl"

vec3 radianceAt(vec2 uv) {
  return compositeRadiance(texelFetch(uGBufferAlbedo, ivec2(uv * vec2(textureSize(uGBufferAlbedo, 0))), 0), uv);
}

#include "lib/metering.glsl"

in vec2 vUv;

out vec4 oLogLuminance;

void main() {
  vec2 cell = floor(gl_FragCoord.xy);
  oLogLuminance = vec4(meterCell(cell, gl_FragCoord.xy / vUv), 0.0, 1.0);
}
