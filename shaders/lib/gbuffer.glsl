// How surfaces are kept in textures of 8 bits.

// Of an albedo times its relief.
const float ALBEDO_SCALE = 1.4;
// What a surface is: 0 to METAL is how much of it is metal.
const float METAL = 0.5;
const float WAX = 1.0;

// While the eye moves: how a surface lies, as it is; what it is, in steps, and between them its roughness.
const float MATERIAL_STEPS = 7.0;
const float ROUGHNESS_STEPS = 32.0;

vec4 encodeReducedSurface(vec3 normal, float roughness, float kind) {
  float rough = floor(clamp(roughness, 0.03, 1.0) * (ROUGHNESS_STEPS - 1.0) + 0.5);
  return vec4(normal * 0.5 + 0.5, (floor(kind * MATERIAL_STEPS + 0.5) * ROUGHNESS_STEPS + rough) / 255.0);
}

// Alpha of the paint, while the eye moves, of what goes with it.
const float HELD = 1.0 / 255.0;

// Steps of a place between two texels of light, where it is not simply mixed.
const float GUIDE_STEPS = 14.0;

// The pixel of the picture in the middle of a texel of the light.
ivec2 pixelOfTexel(ivec2 texel, vec2 lightSize, vec2 pictureSize) {
  return ivec2((vec2(texel) + 0.5) / lightSize * pictureSize);
}

// The pixels around that one, by number.
const int AROUND = 4;  // along each axis
const int MIDDLE = 10;

ivec2 aside(int number) {
  return ivec2(number % AROUND, number / AROUND) - AROUND / 2;
}
