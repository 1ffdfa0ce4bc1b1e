#version 300 es
// The wick's glowing tip.   Out: radiance to add, cd/m².
#include "lib/precision.glsl"
#include "lib/depth.glsl"
#include "lib/ember.glsl"

uniform vec3 uRim;    // middle of the candle's rim, m
uniform vec3 uEmber;  // cd/m²

in vec3 vPositionWorld;

out vec4 oRadiance;

// Tolerance of the depth test, m.
const float DEPTH_BIAS = 0.004;

void main() {
  float room = linearDepth(texelFetch(uDepth, ivec2(gl_FragCoord.xy), 0).r);
  float isVisible = step(linearDepth(gl_FragCoord.z) - DEPTH_BIAS, room);
  oRadiance = vec4(uEmber * emberShare(vPositionWorld - uRim) * isVisible, 0.0);
}
