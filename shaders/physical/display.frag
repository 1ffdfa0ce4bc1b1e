#version 300 es
// From the room's light to the screen: exposure, adaptation to candlelight, tone, sRGB, dither.
// In:  radiance, cd/m².   Out: display colour.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/photometry.glsl"
#include "lib/display.glsl"

// Contrast around middle grey, as film has it: candlelight without it looks like fog.
const float CONTRAST = 1.35;
const float MIDDLE_GREY = 0.18;
// Stops above white over which a light loses its hue, and how much of it is lost in the end.
const float BLEACH_STOPS = 11.0;
const float BLEACH = 0.93;

uniform sampler2D uRadiance;
uniform sampler2D uBloom;
uniform float uScattered;  // share of the light that eye and lens scatter
uniform vec3 uAdaptation;
uniform float uTone;  // 1: tone as film has it, 0: clipped

in vec2 vUv;

out vec4 oColor;

vec3 tone(vec3 color) {
  float peak = max(max(color.r, color.g), color.b);
  if (peak <= 0.0) return vec3(0.0);
  vec3 hue = color / peak;
  float level = MIDDLE_GREY * pow(peak / MIDDLE_GREY, CONTRAST);
  float bent = level / (1.0 + 0.22 * level);
  float shown = 1.0 - exp(-bent * 1.05);
  // A power of the hue goes from orange by gold to white; mixing with white would go by salmon.
  float bleach = BLEACH * smoothstep(0.0, BLEACH_STOPS, log2(peak));
  return pow(max(hue, vec3(1e-3)), vec3(1.0 - bleach)) * shown;
}

vec3 shown(vec2 uv) {
  vec3 radiance = mix(texture(uRadiance, uv).rgb, texture(uBloom, uv).rgb, uScattered);
  vec3 exposed = radiance * uAdaptation * frame.exposure;
  return encodeSrgb(uTone > 0.5 ? tone(exposed) : min(exposed, 1.0));
}

// The samples of a pixel were averaged as light, where one that saw the flame outshines all others, so
// its edge is still a staircase on the screen. Across such steps, and only there, neighbours are mixed.
// After Lottes 2009, "FXAA".
vec3 smoothed(vec2 uv) {
  const float STEP = 0.12;  // of luma: less is no edge that anyone sees
  vec2 texel = 1.0 / frame.viewport;
  vec3 here = shown(uv);
  vec3 left = shown(uv - vec2(texel.x, 0.0));
  vec3 right = shown(uv + vec2(texel.x, 0.0));
  vec3 below = shown(uv - vec2(0.0, texel.y));
  vec3 above = shown(uv + vec2(0.0, texel.y));
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
