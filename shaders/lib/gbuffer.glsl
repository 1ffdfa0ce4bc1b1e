// Encoding of the G-buffer in textures of 8 bits.

// Gamma-2 albedo times normal-map shading: largest value.
const float ALBEDO_SCALE = 1.4;

// Material: 0 to METAL is how much of the surface is metal.
const float METAL = 0.5;
const float GLASS = 5.0 / 7.0;
const float WAX = 1.0;

bool isWax(float material) {
  return material > 0.5 * (GLASS + WAX);
}

bool isGlass(float material) {
  return material > 0.5 * (METAL + GLASS) && !isWax(material);
}

float metallicOf(float material) {
  return material < 0.5 * (METAL + GLASS) ? min(material / METAL, 1.0) : 0.0;
}

// Reduced G-buffer: normal in rgb; material in steps, and roughness between them, in a.
const float MATERIAL_STEPS = 7.0;
const float ROUGHNESS_STEPS = 32.0;

vec4 encodeReducedSurface(vec3 normal, float roughness, float material) {
  float rough = floor(clamp(roughness, 0.03, 1.0) * (ROUGHNESS_STEPS - 1.0) + 0.5);
  float code = floor(material * MATERIAL_STEPS + 0.5) * ROUGHNESS_STEPS + rough;
  return vec4(normal * 0.5 + 0.5, code / 255.0);
}

// Alpha of the reduced albedo for surfaces that move with the camera.
const float HELD = 1.0 / 255.0;

// 1 for such a surface, else 0. `stored`: that alpha.
float isHeldSurface(float stored) {
  return step(0.5 * HELD, stored);
}

// Steps of the upsample guide between two lighting texels.
const float GUIDE_STEPS = 14.0;

// The G-buffer sample at the center of a lighting texel.
ivec2 sampleAtTexel(ivec2 texel, vec2 lightingSize, vec2 samples) {
  return ivec2((vec2(texel) + 0.5) / lightingSize * samples);
}

// Candidates for the sample that represents a lighting texel: a square around the center.
const int CANDIDATES = 4;  // along each axis
const int CENTER = 10;

ivec2 candidateOffset(int candidate) {
  return ivec2(candidate % CANDIDATES, candidate / CANDIDATES) - CANDIDATES / 2;
}
