#version 300 es
// Exposure, bloom, display transform, antialiasing and dither.
// In:  radiance, cd/m².   Out: display colour.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/compile-time.glsl"
#include "lib/display-transform.glsl"
#if TONE_LUT
#include "lib/tone-lut.glsl"
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
  vec3 color = lookUpTone(share);
  float sum = share.r + share.g + share.b;
  int exact = sum > 1.0 || min(min(share.r, share.g), share.b) < TONE_LUT_LEAST * sum ? 1 : 0;
  for (int i = 0; i < exact; i++) color = displayColor(light);
  return color;
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
  vec3 neighbors[4] = vec3[4](
    textureLodOffset(uRadiance, uv, 0.0, ivec2(-1, 0)).rgb, textureLodOffset(uRadiance, uv, 0.0, ivec2(1, 0)).rgb,
    textureLodOffset(uRadiance, uv, 0.0, ivec2(0, -1)).rgb, textureLodOffset(uRadiance, uv, 0.0, ivec2(0, 1)).rgb);
  vec4 luminances = vec4(luma(neighbors[0]), luma(neighbors[1]), luma(neighbors[2]), luma(neighbors[3]));
  luminances = max(luminances * exposure + luma(glare), 0.0);
  float difference = approximateLuma(most(luminances)) - approximateLuma(least(luminances));
  // Software renderers execute both sides of an `if`, but skip a loop that no pixel enters. Compilers move what does not
  // depend on its variable out of it.
  vec3 around = here;
  for (vec4 beside = difference < EDGE ? vec4(-1.0) : luminances; beside.x >= 0.0; beside = vec4(-1.0)) {
    // Averaged on the scale of the approximate luma, so that one display transform is enough for all four.
    vec4 shares = 0.25 * inversesqrt(max(beside * (beside + 1.0), 1e-6));
    vec3 mean = mat4x3(neighbors[0], neighbors[1], neighbors[2], neighbors[3]) * shares * exposure + glare * dot(shares, vec4(1.0));
    float meanLuma = luma(mean);
    around = fastDisplayColor(mean * (meanLuma / max(1.0 - meanLuma * meanLuma, 1e-3)));
  }
  return mix(here, around, 0.6 * smoothstep(EDGE, 3.0 * EDGE, difference));
}

void main() {
  COMPILE_ONCE;
  oColor = vec4(antialiasedColor(vUv) + dither(gl_FragCoord.xy), 1.0);
}
