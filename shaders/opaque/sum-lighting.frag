#version 300 es
// Sum of the lights' deferred lighting, as that of one light of the colour uColor.
// In:  lighting of the sum so far, and of one more light for each candela or lux.   Out: the same, of all.
#include "lib/precision.glsl"
#include "lib/photometry.glsl"

uniform sampler2D uLighting;
uniform sampler2D uCachedLighting;
uniform vec3 uIntensity;      // of the flame, cd
uniform vec3 uCachedIntensity;  // cd or lx
uniform vec3 uColor;          // luma 1

out vec4 oLighting;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 lighting = texelFetch(uLighting, texel, 0);
  vec4 sum = lighting * lighting * vec4(uIntensity / uColor, luma(uIntensity));
  lighting = texelFetch(uCachedLighting, texel, 0);
  sum += lighting * lighting * vec4(uCachedIntensity / uColor, luma(uCachedIntensity));
  oLighting = sqrt(min(sum, 6e4));
}
