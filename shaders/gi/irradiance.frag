#version 300 es
// Irradiance after all bounces, by the last three sums of the series.
// In:  lx, and weights.   Out: lx.
#include "lib/precision.glsl"

uniform sampler2D uLast;
uniform sampler2D uPrevious;
uniform sampler2D uBefore;
uniform sampler2D uPreviousWeight;  // gi/bounce-limit.frag
uniform sampler2D uBeforeWeight;

out vec4 oIrradiance;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec3 last = texelFetch(uLast, texel, 0).rgb;
  vec3 irradiance = last;
  irradiance += (texelFetch(uPrevious, texel, 0).rgb - last) * texelFetch(uPreviousWeight, ivec2(0), 0).rgb;
  irradiance += (texelFetch(uBefore, texel, 0).rgb - last) * texelFetch(uBeforeWeight, ivec2(0), 0).rgb;
  oIrradiance = vec4(max(irradiance, 0.0), 1.0);
}
