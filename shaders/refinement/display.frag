#version 300 es
// The refined image around the flame, whose glare comes on top of it; or all of it, before its colours are kept.
// In:  radiance per candela, bloom; KEPT: display colours in two lights.   Out: display colour.
#include "lib/precision.glsl"
#include "lib/srgb.glsl"
#include "lib/flame-light.glsl"
#include "lib/tone-lut.glsl"

uniform sampler2D uRadiance;
uniform sampler2D uBloom;
uniform vec4 uBloomTransform;  // from uv of the frame to uv of the bloom: scale, offset
uniform vec3 uWhiteBalance;  // makes candlelight white
uniform float uGlareShare;   // share of the light that lens and eye scatter
#if KEPT
uniform sampler2D uDimmer;
uniform sampler2D uBrighter;
uniform vec4 uGlareBounds;   // where glare is added: left, bottom, right, top, pixels
#endif

in vec2 vUv;
flat in float vExposure;
flat in float vShare;

out vec4 oColor;

#if KEPT
// Pixels from the bounds over which glare fades out, where it is less than a hundredth of white.
const float GLARE_FADE = 64.0;

float glareFade() {
  vec4 inside = vec4(gl_FragCoord.xy - uGlareBounds.xy, uGlareBounds.zw - gl_FragCoord.xy);
  return smoothstep(0.0, GLARE_FADE, min(min(inside.x, inside.y), min(inside.z, inside.w)));
}
#endif

vec3 shown(vec3 radiance) {
  return lookUpTone(radiance * uWhiteBalance * (vExposure / TONE_LUT_MAX));
}

void main() {
  vec3 radiance = texture(uRadiance, vUv).rgb * light.intensity;
  vec3 glare = texture(uBloom, vUv * uBloomTransform.xy + uBloomTransform.zw).rgb * uGlareShare;
#if KEPT
  glare *= glareFade();
  vec3 kept = mix(texture(uDimmer, vUv), texture(uBrighter, vUv), vShare).rgb;
  oColor = vec4(kept + shown(radiance + glare) - shown(radiance), 1.0);
#else
  // The same dither for all channels.
  oColor = vec4(shown(radiance + glare) + dither(gl_FragCoord.xy).r, 1.0);
#endif
}
