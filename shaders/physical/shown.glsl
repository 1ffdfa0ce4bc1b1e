// What a light looks like on the screen: adaptation to candlelight, tone, sRGB.
#include "lib/display.glsl"

// Contrast around middle grey, as film has it: candlelight without it looks like fog.
const float CONTRAST = 1.35;
const float MIDDLE_GREY = 0.18;
// Stops above white over which a light loses its hue, and how much of it is lost in the end.
const float BLEACH_STOPS = 11.0;
const float BLEACH = 0.93;

uniform vec3 uAdaptation;
uniform float uTone;  // 1: tone as film has it, 0: clipped

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

// Exposed light in, where white is about 1.
vec3 shown(vec3 light) {
  vec3 seen = light * uAdaptation;
  return encodeSrgb(uTone > 0.5 ? tone(seen) : min(seen, 1.0));
}
