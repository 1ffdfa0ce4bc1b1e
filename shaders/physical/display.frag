#version 300 es
// From the room's light to the screen: exposure, adaptation to candlelight, tone, sRGB, dither.
// In:  radiance, cd/m².   Out: display colour.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/photometry.glsl"
#include "physical/shown.glsl"

uniform sampler2D uRadiance;
uniform sampler2D uBloom;
uniform float uScattered;  // share of the light that eye and lens scatter

in vec2 vUv;

out vec4 oColor;

vec3 shownAt(vec2 uv) {
  vec3 radiance = mix(texture(uRadiance, uv).rgb, texture(uBloom, uv).rgb, uScattered);
  return shown(radiance * frame.exposure);
}

// The samples of a pixel were averaged as light, where one that saw the flame outshines all others, so
// its edge is still a staircase on the screen. Across such steps, and only there, neighbours are mixed.
// After Lottes 2009, "FXAA".
vec3 smoothed(vec2 uv) {
  const float STEP = 0.12;  // of luma: less is no edge that anyone sees
  vec2 texel = 1.0 / frame.viewport;
  vec3 here = shownAt(uv);
  vec3 left = shownAt(uv - vec2(texel.x, 0.0));
  vec3 right = shownAt(uv + vec2(texel.x, 0.0));
  vec3 below = shownAt(uv - vec2(0.0, texel.y));
  vec3 above = shownAt(uv + vec2(0.0, texel.y));
  vec4 around = vec4(luma(left), luma(right), luma(below), luma(above));
  float low = min(min(around.x, around.y), min(around.z, around.w));
  float high = max(max(around.x, around.y), max(around.z, around.w));
  if (high - low < STEP) return here;
  vec3 mean = (left + right + below + above) * 0.25;
  return mix(here, mean, 0.6 * smoothstep(STEP, 3.0 * STEP, high - low));
}

void main() {
  oColor = vec4(smoothed(vUv) + dither(gl_FragCoord.xy), 1.0);
}
