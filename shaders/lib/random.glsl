// Hash-based random numbers, bit-identical to those of src/world/random.ts.
// Jarzynski and Olano 2020, "Hash Functions for GPU Rendering", JCGT 9(3): PCG-RXS-M-XS, 32 bit.

uint pcg(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// In [0, 1). 24 bits, so that it is exact as a float.
float unit(uint hash) {
  return float(hash >> 8) * (1.0 / 16777216.0);
}

// Two numbers in [-1, 1), of 16 bits each.
vec2 signedHalves(uint hash) {
  return vec2(int(hash) >> 16, int(hash << 16) >> 16) * (1.0 / 32768.0);
}
