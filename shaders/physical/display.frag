#version 300 es
// From the room's light to the screen: exposure, adaptation to candlelight, tone, sRGB, dither.
// In:  radiance, cd/m².   Out: display colour.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/photometry.glsl"
#include "lib/display.glsl"

// Contrast around middle grey, as film has it: candlelight without it looks like fog.
const float CONTRAST = 1.3;
const float MIDDLE_GREY = 0.18;
// Stops above white at which a light loses its hue, and at which none is left.
const float BLEACH_BEGIN = 6.0;
const float BLEACH_END = 21.0;

uniform sampler2D uRadiance;
uniform sampler2D uBloom;
uniform float uScattered;  // share of the light that eye and lens scatter
uniform vec3 uAdaptation;

in vec2 vUv;

out vec4 oColor;

vec3 tone(vec3 color) {
  float peak = max(max(color.r, color.g), color.b);
  if (peak <= 0.0) return vec3(0.0);
  vec3 hue = color / peak;
  float level = MIDDLE_GREY * pow(peak / MIDDLE_GREY, CONTRAST);
  float bent = level / (1.0 + 0.22 * level);
  float shown = 1.0 - exp(-bent * 1.05);
  float bleach = smoothstep(BLEACH_BEGIN, BLEACH_END, log2(max(peak, 1e-6)));
  return mix(hue, vec3(1.0), bleach) * shown;
}

void main() {
  vec3 radiance = mix(texture(uRadiance, vUv).rgb, texture(uBloom, vUv).rgb, uScattered);
  vec3 adapted = radiance * uAdaptation * frame.exposure;
  oColor = vec4(encodeSrgb(tone(adapted)) + dither(gl_FragCoord.xy), 1.0);
}
