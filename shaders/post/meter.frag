#version 300 es
// How bright each part of the picture is, the flame left out.
// In:  radiance, cd/m².   Out: red: mean of log2 luminance; green: how much of the part that speaks for.
#include "lib/precision.glsl"
#include "lib/photometry.glsl"

uniform sampler2D uRadiance;

vec3 radianceAt(vec2 uv) {
  return texelFetch(uRadiance, ivec2(uv * vec2(textureSize(uRadiance, 0))), 0).rgb;
}

#include "lib/metering.glsl"

in vec2 vUv;

out vec4 oBrightness;

void main() {
  vec2 part = floor(gl_FragCoord.xy);
  oBrightness = vec4(meterCell(part, gl_FragCoord.xy / vUv), 0.0, 1.0);
}
