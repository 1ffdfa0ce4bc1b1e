// How bright a part of the picture is, the flame left out.
// Needs lib/photometry.glsl, and before it: vec3 radianceAt(vec2 uv), cd/m².

// Taps along either side of a part. Luminances, as powers of 2, from which on a thing is taken less and
// less for a surface: only the flame, and mirrors of it, are beyond.
const int TAPS = 4;
const float DARKEST = 1e-4;  // cd/m²
const float SURFACE = 3.0;
const float FLAME = 6.0;

// Mean of log2 luminance, and how much of the part that speaks for. `parts`: how many there are.
vec2 meterCell(vec2 part, vec2 parts) {
  float sum = 0.0;
  float weights = 0.0;
  for (int i = 0; i < TAPS * TAPS; i++) {
    vec2 tap = (vec2(i % TAPS, i / TAPS) + 0.5) / float(TAPS);
    float brightness = log2(max(luma(radianceAt((part + tap) / parts)), DARKEST));
    float weight = 1.0 - smoothstep(SURFACE, FLAME, brightness);
    sum += brightness * weight;
    weights += weight;
  }
  return vec2(sum / max(weights, 1e-3), weights / float(TAPS * TAPS));
}
