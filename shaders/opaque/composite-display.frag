#version 300 es
// Composite of the deferred stage and display transform in one, by the tone LUT.
// In:  G-buffer, lighting; BLOOM: bloom.   Out: display colour.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/compile-time.glsl"
#include "lib/srgb.glsl"
#include "lib/flame-light.glsl"
#include "lib/composite.glsl"
#include "lib/tone-lut.glsl"

#if BLOOM
uniform sampler2D uBloom;
uniform vec4 uBloomTransform;  // from uv of the frame to uv of the bloom: scale, offset
uniform float uGlareShare;   // share of the light that lens and eye scatter
#endif
uniform vec3 uWhiteBalance;  // makes candlelight white

in vec2 vUv;
flat in float vExposure;

out vec4 oColor;

void main() {
  COMPILE_ONCE;
  vec4 albedo = texelFetch(uGBufferAlbedo, ivec2(gl_FragCoord.xy), 0);
  vec3 radiance = compositeRadiance(albedo, vUv);
#if BLOOM
  radiance += texture(uBloom, vUv * uBloomTransform.xy + uBloomTransform.zw).rgb * uGlareShare;
#endif
  vec3 exposed = max(radiance, 0.0) * uWhiteBalance * (vExposure / TONE_LUT_MAX);
  // The same dither for all channels.
  oColor = vec4(lookUpTone(exposed) + dither(gl_FragCoord.xy).r, 1.0);
}
