// Light metering of one cell of the frame, the flame excluded.
// Needs lib/photometry.glsl, and before it: vec3 radianceAt(vec2 uv), cd/m².

// Taps along an edge of a cell.
const int TAPS = 4;
const float DARKEST = 1e-4;  // cd/m²
// Logarithms of luminance between which the weight falls to 0: only the flame and its mirror images are beyond.
const float SURFACE = 3.0;
const float FLAME = 6.0;

// Mean of weighted log2 luminance, and of the weight. `cells`: number of cells.
vec2 meterCell(vec2 cell, vec2 cells) {
  float sum = 0.0;
  float weights = 0.0;
  for (int i = 0; i < TAPS * TAPS; i++) {
    vec2 tap = (vec2(i % TAPS, i / TAPS) + 0.5) / float(TAPS);
    float logLuminance = log2(max(luma(radianceAt((cell + tap) / cells)), DARKEST));
    float weight = 1.0 - smoothstep(SURFACE, FLAME, logLuminance);
    sum += logLuminance * weight;
    weights += weight;
  }
  return vec2(sum, weights) / float(TAPS * TAPS);
}
