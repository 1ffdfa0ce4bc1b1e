#version 300 es
// Light metering of each cell of the frame, the flame excluded.
// In:  radiance, cd/m².   Out: red: mean of weighted log2 luminance; green: of the weight.
#include "lib/precision.glsl"
#include "lib/photometry.glsl"

uniform sampler2D uRadiance;

vec3 radianceAt(vec2 uv) {
  return texelFetch(uRadiance, ivec2(uv * vec2(textureSize(uRadiance, 0))), 0).rgb;
}

#include "lib/metering.glsl"

in vec2 vUv;

out vec4 oLogLuminance;

void main() {
  vec2 cell = floor(gl_FragCoord.xy);
  oLogLuminance = vec4(meterCell(cell, gl_FragCoord.xy / vUv), 0.0, 1.0);
}
