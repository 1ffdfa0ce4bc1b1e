// How surfaces are kept in textures of 8 bits.

// Of an albedo times its relief.
const float BRIGHTEST = 1.4;
// What a surface is: 0 to METAL is how much of it is metal.
const float METAL = 0.5;
const float WAX = 1.0;

// Steps of a place between two texels of light, where it is not simply mixed.
const float PLACES = 14.0;

// The pixel of the picture at which a texel of the light is worked out.
ivec2 pixelOf(ivec2 texel, vec2 lightSize, vec2 pictureSize) {
  return ivec2((vec2(texel) + 0.5) / lightSize * pictureSize);
}
