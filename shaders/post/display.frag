#version 300 es
// Exposure, bloom, display transform, antialiasing and dither.
// In:  radiance, cd/m².   Out: display colour.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/display-transform.glsl"
#if TONE_LUT
#include "lib/tone-lut.glsl"
#include "lib/tone-lut-lookup.glsl"
#endif

uniform sampler2D uRadiance;
uniform sampler2D uBloom;
uniform vec4 uBloomTransform;  // from uv on the frame to uv on the bloom: scale, offset
uniform float uGlareShare;  // share of the light that eye and lens scatter

in vec2 vUv;
flat in float vExposure;

out vec4 oColor;

// Cheap approximation of the display luma of a luminance.
vec4 approximateLuma(vec4 luminance) {
  return sqrt(luminance / (luminance + 1.0));
}

vec4 luma(vec3 a, vec3 b, vec3 c, vec3 d) {
  return max(vec4(luma(a), luma(b), luma(c), luma(d)), 0.0);
}

float range(vec4 values) {
  return max(max(values.x, values.y), max(values.z, values.w)) -
    min(min(values.x, values.y), min(values.z, values.w));
}

vec3 fastDisplayColor(vec3 light) {
#if TONE_LUT
  vec3 share = max(light, 0.0) * uAdaptation / (uWhite * TONE_LUT_MAX);
  if (max(max(share.r, share.g), share.b) <= 1.0) return lookUpTone(share);
#endif
  return displayColor(light);
}

// Antialiasing after the tone curve. A pixel's samples are averaged as light, where one of the flame outshines all
// others, so the flame's edge is still aliased: neighbours are mixed across it. After Lottes 2009, "FXAA".
vec3 antialiasedColor(vec2 uv) {
  const float EDGE = 0.12;  // least visible difference of luma
  vec2 texel = 1.0 / frame.viewport;
  vec3 glare = texture(uBloom, uv * uBloomTransform.xy + uBloomTransform.zw).rgb * (vExposure * uGlareShare);
  float exposure = vExposure * (1.0 - uGlareShare);
  vec3 here = fastDisplayColor(texture(uRadiance, uv).rgb * exposure + glare);
  vec3 left = texture(uRadiance, uv - vec2(texel.x, 0.0)).rgb * exposure + glare;
  vec3 right = texture(uRadiance, uv + vec2(texel.x, 0.0)).rgb * exposure + glare;
  vec3 below = texture(uRadiance, uv - vec2(0.0, texel.y)).rgb * exposure + glare;
  vec3 above = texture(uRadiance, uv + vec2(0.0, texel.y)).rgb * exposure + glare;
  if (range(approximateLuma(luma(left, right, below, above))) < 0.5 * EDGE) return here;
  left = fastDisplayColor(left);
  right = fastDisplayColor(right);
  below = fastDisplayColor(below);
  above = fastDisplayColor(above);
  float contrast = range(luma(left, right, below, above));
  vec3 mean = (left + right + below + above) * 0.25;
  return mix(here, mean, 0.6 * smoothstep(EDGE, 3.0 * EDGE, contrast));
}

void main() {
  oColor = vec4(antialiasedColor(vUv) + dither(gl_FragCoord.xy), 1.0);
}
