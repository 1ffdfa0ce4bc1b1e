// From light as the eye takes it to what a screen can show, linear. It only ever rises with the light,
// and bends all channels by one factor, so that hues stay. What is far above white goes by gold to white.

// Contrast around middle grey, as film has it: candlelight without it looks like fog.
const float CONTRAST = 1.5;
const float MIDDLE_GREY = 0.18;
// A light loses its hue by so much for every stop above white, from the second on; but never all of it.
// The slope leaves a flame, ten to sixteen stops above, its gold rim around a yellow core.
const float BLEACH = 0.053;
const float MOST_BLEACH = 0.92;
// Share of green or blue, from which on a light goes pale at all: embers have less, and stay red.
const vec2 GOLDEN = vec2(0.1, 0.45);

vec3 tone(vec3 color) {
  float peak = max(max(color.r, color.g), color.b);
  if (peak <= 0.0) return vec3(0.0);
  vec3 hue = max(color / peak, vec3(1e-3));
  float level = MIDDLE_GREY * pow(peak / MIDDLE_GREY, CONTRAST);
  // Reinhard et al. 2002, "Photographic Tone Reproduction for Digital Images": a table top by the candle
  // is nearly as bright as a screen can be, and keeps its grain.
  float shown = level / (1.0 + level);
  // A mixture with white would go from orange by salmon; so green comes up before blue.
  float stops = max(log2(peak), 0.0);
  float bleach = min(BLEACH * stops * stops / (stops + 1.0), MOST_BLEACH);
  bleach *= smoothstep(GOLDEN.x, GOLDEN.y, max(hue.g, hue.b));
  return pow(hue, 1.0 - vec3(bleach, bleach, bleach * bleach)) * shown;
}
