#version 300 es
// Exposure, bloom, display transform, antialiasing and dither.
// In:  radiance, cd/m².   Out: display colour.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/display-transform.glsl"
#if TONE_LUT
#include "lib/tone-lut.glsl"
#include "lib/tone-lut-lookup.glsl"
#else
#include "lib/hue-lut.glsl"
#endif

uniform sampler2D uRadiance;
uniform sampler2D uBloom;
uniform vec4 uBloomTransform;  // from uv on the frame to uv on the bloom: scale, offset
uniform float uGlareShare;  // share of the light that eye and lens scatter
uniform vec3 uWhiteBalance;  // makes candlelight white

in vec2 vUv;
flat in float vExposure;

out vec4 oColor;

// Cheap approximation of the display luma of a luminance.
float approximateLuma(float luminance) {
  return sqrt(luminance / (luminance + 1.0));
}

vec4 luma(vec3 a, vec3 b, vec3 c, vec3 d) {
  return vec4(luma(a), luma(b), luma(c), luma(d));
}

float least(vec4 values) {
  return min(min(values.x, values.y), min(values.z, values.w));
}

float most(vec4 values) {
  return max(max(values.x, values.y), max(values.z, values.w));
}

vec3 fastDisplayColor(vec3 light) {
  vec3 balanced = max(light, 0.0) * uWhiteBalance;
#if TONE_LUT
  vec3 share = balanced / TONE_LUT_MAX;
  return max(max(share.r, share.g), share.b) <= 1.0 ? lookUpTone(share) : displayColor(light);
#else
  return toneAndEncodeVivid(lookUpVibrance(balanced));
#endif
}

// Antialiasing after the tone curve. A pixel's samples are averaged as light, where one of the flame outshines all
// others, so the flame's edge is still aliased: neighbours are mixed across it. After Lottes 2009, "FXAA".
vec3 antialiasedColor(vec2 uv) {
  const float EDGE = 0.12;  // least visible difference of luma
  vec3 glare = texture(uBloom, uv * uBloomTransform.xy + uBloomTransform.zw).rgb * (vExposure * uGlareShare);
  float exposure = vExposure * (1.0 - uGlareShare);
  vec3 here = fastDisplayColor(texture(uRadiance, uv).rgb * exposure + glare);
  vec3 left = textureLodOffset(uRadiance, uv, 0.0, ivec2(-1, 0)).rgb;
  vec3 right = textureLodOffset(uRadiance, uv, 0.0, ivec2(1, 0)).rgb;
  vec3 below = textureLodOffset(uRadiance, uv, 0.0, ivec2(0, -1)).rgb;
  vec3 above = textureLodOffset(uRadiance, uv, 0.0, ivec2(0, 1)).rgb;
  vec4 luminance = max(luma(left, right, below, above) * exposure + luma(glare), 0.0);
  if (approximateLuma(most(luminance)) - approximateLuma(least(luminance)) < 0.5 * EDGE) return here;
  left = fastDisplayColor(left * exposure + glare);
  right = fastDisplayColor(right * exposure + glare);
  below = fastDisplayColor(below * exposure + glare);
  above = fastDisplayColor(above * exposure + glare);
  vec4 shown = luma(left, right, below, above);
  float contrast = most(shown) - least(shown);
  vec3 mean = (left + right + below + above) * 0.25;
  return mix(here, mean, 0.6 * smoothstep(EDGE, 3.0 * EDGE, contrast));
}

void main() {
  oColor = vec4(antialiasedColor(vUv) + dither(gl_FragCoord.xy), 1.0);
}
