// Tone curve: from adapted light to linear display light. It is monotonic, and scales all channels by one factor, so
// that hue stays; highlights far above white bleach through gold to white.

// Contrast around middle grey: src/light/night-vision.ts.
uniform float uContrast;
const float MIDDLE_GREY = 0.18;
// Desaturation for every stop above white, from the second on, and its limit. The slope leaves a flame, ten to sixteen
// stops above, its gold rim around a yellow core.
const float BLEACH = 0.053;
const float MOST_BLEACH = 0.92;
// Share of green or blue from which on highlights bleach at all: embers have less, and stay red.
const vec2 GOLDEN = vec2(0.1, 0.45);

vec3 tone(vec3 color) {
  float peak = max(max(color.r, color.g), color.b);
  if (peak <= 0.0) return vec3(0.0);
  vec3 hue = max(color / peak, vec3(1e-3));
  float level = MIDDLE_GREY * pow(peak / MIDDLE_GREY, uContrast);
  // Reinhard et al. 2002, "Photographic Tone Reproduction for Digital Images".
  float compressed = level / (1.0 + level);
  vec3 shown = hue * compressed;
  // Software renderers execute both sides of an `if`, but skip a loop that no pixel enters.
  for (float excess = peak; excess > 1.0; excess = 0.0) {
    // A mixture with white would go from orange by salmon; so green rises before blue.
    float stops = log2(excess);
    float bleach = min(BLEACH * stops * stops / (stops + 1.0), MOST_BLEACH);
    bleach *= smoothstep(GOLDEN.x, GOLDEN.y, max(hue.g, hue.b));
    shown = pow(hue, 1.0 - vec3(bleach, bleach, bleach * bleach)) * compressed;
  }
  return shown;
}
