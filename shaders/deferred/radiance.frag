#version 300 es
// The room's light, where more is to be drawn over it.
// Out: radiance, cd/m²; depth, where only coarse surfaces have one so far.
#include "lib/precision.glsl"
#include "physical/light.glsl"
#include "deferred/stored.glsl"
#if COARSE
#include "physical/depth.glsl"
#if KEPT
#include "deferred/since.glsl"
#endif
#include "deferred/guessed.glsl"
#else
#include "deferred/told.glsl"
#endif
#include "deferred/lit.glsl"

in vec2 vUv;

out vec4 oRadiance;

void main() {
  oRadiance = vec4(min(litAt(vUv), 3e4), 1.0);
#if COARSE
  // Before the farthest, or it would not be drawn.
  gl_FragDepth = min(depthOf(vUv), 0.9999999);
#endif
}
