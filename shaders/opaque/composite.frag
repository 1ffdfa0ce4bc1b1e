#version 300 es
// Composite of the deferred stage: albedo x lighting, upsampled.
// Out: radiance, cd/m²; REDUCED: depth at the canvas's size.
#include "lib/precision.glsl"
#include "lib/flame-light.glsl"
#include "lib/composite.glsl"

#if REDUCED
uniform vec2 uSampleOffset;  // from a texel's center to its sample, unless it is held, uv
#endif

in vec2 vUv;

out vec4 oRadiance;

void main() {
#if REDUCED
  vec2 uv = vUv - uSampleOffset * (1.0 - isHeldSurface(texture(uGBufferAlbedo, vUv).a));
#else
  vec2 uv = vUv;
#endif
  oRadiance = vec4(min(compositeRadiance(texture(uGBufferAlbedo, uv), uv), 3e4), 1.0);
#if REDUCED
  // Less than the cleared depth, or the test would reject it.
  gl_FragDepth = min(frameDepth(uv), 0.9999999);
#endif
}
