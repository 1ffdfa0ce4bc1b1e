#version 300 es
// From the room's light to the screen: exposure, adaptation to candlelight, tone, sRGB, dither.
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
uniform vec4 uBloomTransform;  // of the picture on the bloom's texture: its size and its corner
uniform float uGlareShare;  // share of the light that eye and lens scatter

in vec2 vUv;
flat in float vExposure;

out vec4 oColor;

// Roughly the luma on the screen of a light, at a fraction of the cost.
vec4 roughly(vec4 luminance) {
  return sqrt(luminance / (luminance + 1.0));
}

vec4 luma(vec3 a, vec3 b, vec3 c, vec3 d) {
  return max(vec4(luma(a), luma(b), luma(c), luma(d)), 0.0);
}

float range(vec4 values) {
  return max(max(values.x, values.y), max(values.z, values.w)) -
    min(min(values.x, values.y), min(values.z, values.w));
}

vec3 onScreen(vec3 light) {
#if TONE_LUT
  vec3 share = max(light, 0.0) * uAdaptation / (uWhite * TONE_LUT_MAX);
  if (max(max(share.r, share.g), share.b) <= 1.0) return lookUpTone(share);
#endif
  return shown(light);
}

// The samples of a pixel were averaged as light, where one that saw the flame outshines all others, so
// its edge is still a staircase on the screen. Across such steps, and only there, neighbours are mixed.
// After Lottes 2009, "FXAA".
vec3 smoothed(vec2 uv) {
  const float STEP = 0.12;  // of luma: less is no edge that anyone sees
  vec2 texel = 1.0 / frame.viewport;
  vec3 glare = texture(uBloom, uv * uBloomTransform.xy + uBloomTransform.zw).rgb * (vExposure * uGlareShare);
  float kept = vExposure * (1.0 - uGlareShare);
  vec3 here = onScreen(texture(uRadiance, uv).rgb * kept + glare);
  vec3 left = texture(uRadiance, uv - vec2(texel.x, 0.0)).rgb * kept + glare;
  vec3 right = texture(uRadiance, uv + vec2(texel.x, 0.0)).rgb * kept + glare;
  vec3 below = texture(uRadiance, uv - vec2(0.0, texel.y)).rgb * kept + glare;
  vec3 above = texture(uRadiance, uv + vec2(0.0, texel.y)).rgb * kept + glare;
  if (range(roughly(luma(left, right, below, above))) < 0.5 * STEP) return here;
  left = onScreen(left);
  right = onScreen(right);
  below = onScreen(below);
  above = onScreen(above);
  float edge = range(luma(left, right, below, above));
  vec3 mean = (left + right + below + above) * 0.25;
  return mix(here, mean, 0.6 * smoothstep(STEP, 3.0 * STEP, edge));
}

void main() {
  oColor = vec4(smoothed(vUv) + dither(gl_FragCoord.xy), 1.0);
}
