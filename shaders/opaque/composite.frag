#version 300 es
// The room's light, where more is to be drawn over it.
// Out: radiance, cd/m²; depth, where only coarse surfaces have one so far.
#include "lib/precision.glsl"
#include "lib/flame-light.glsl"
#include "lib/gbuffer.glsl"
#if COARSE
#include "lib/depth.glsl"
#if HISTORY
#include "lib/reproject.glsl"
#endif
#include "lib/upsample-bilateral.glsl"
#else
#include "lib/upsample-guided.glsl"
#endif
#include "lib/composite.glsl"

in vec2 vUv;

out vec4 oRadiance;

void main() {
  oRadiance = vec4(min(compositeRadianceAt(vUv), 3e4), 1.0);
#if COARSE
  // Before the farthest, or it would not be drawn.
  gl_FragDepth = min(depthOf(vUv), 0.9999999);
#endif
}
