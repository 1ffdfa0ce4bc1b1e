#version 300 es
// An irradiance volume, with what is left of it without a first bounce.
// Out: lx; alpha: the luma of the rest.
#include "lib/precision.glsl"
#include "lib/photometry.glsl"

uniform sampler2D uIrradiance;
uniform sampler2D uFirstBounce;

out vec4 oIrradiance;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec3 all = texelFetch(uIrradiance, texel, 0).rgb;
  oIrradiance = vec4(all, max(luma(all - texelFetch(uFirstBounce, texel, 0).rgb), 0.0));
}
