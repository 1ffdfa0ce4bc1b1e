#version 300 es
// Composite of the deferred stage: albedo x lighting, upsampled.
// Out: radiance, cd/m²; REDUCED: depth at the canvas's size.
#include "lib/precision.glsl"
#include "lib/flame-light.glsl"
#include "lib/composite.glsl"

in vec2 vUv;

out vec4 oRadiance;

void main() {
  oRadiance = vec4(min(compositeRadiance(texture(uGBufferAlbedo, vUv), vUv), 3e4), 1.0);
#if REDUCED
  // Less than the cleared depth, or the test would reject it.
  gl_FragDepth = min(frameDepth(vUv), 0.9999999);
#endif
}
