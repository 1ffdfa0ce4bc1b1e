// What a depth prepass tells of a fragment of the refined image: a software renderer shades what depth then hides.

uniform highp sampler2D uPrepassDepth;  // of the frame, one sample a pixel

// Depths on one surface differ by rounding: a millimetre at 3 m.
const float SAME_DEPTH = 1e-6;

bool isVisibleAt(ivec2 pixel) {
  float depth = gl_FragCoord.z;
  ivec2 end = textureSize(uPrepassDepth, 0) - 1;
  float farthest = 0.0;
  for (int y = -1; y <= 1; y++) {
    for (int x = -1; x <= 1; x++) {
      farthest = max(farthest, texelFetch(uPrepassDepth, clamp(pixel + ivec2(x, y), ivec2(0), end), 0).r);
    }
  }
  // In a corner between two planes, that of a sample may lie behind both at the pixel's centre.
  float beyond = abs(dFdx(depth)) + abs(dFdy(depth));
  return depth <= farthest + beyond + SAME_DEPTH;
}
