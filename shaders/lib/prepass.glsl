// What a depth prepass tells of a fragment of the refined image: a software renderer shades what depth then hides.

uniform highp sampler2D uPrepassDepth;  // of the frame, one sample a pixel
uniform float uIsMultisampled;          // 1 or 0: whether a pixel has several samples now

// Depths on one surface differ by rounding: a millimetre at 3 m.
const float SAME_DEPTH = 1e-6;

bool isVisibleAt(ivec2 pixel) {
  float depth = gl_FragCoord.z;
  ivec2 end = textureSize(uPrepassDepth, 0) - 1;
  int reach = uIsMultisampled > 0.5 ? 1 : 0;
  float farthest = 0.0;
  for (int y = -reach; y <= reach; y++) {
    for (int x = -reach; x <= reach; x++) {
      farthest = max(farthest, texelFetch(uPrepassDepth, clamp(pixel + ivec2(x, y), ivec2(0), end), 0).r);
    }
  }
  // In a corner between two planes, that of a sample may lie behind both at the pixel's centre.
  float beyond = float(reach) * (abs(dFdx(depth)) + abs(dFdy(depth)));
  return depth <= farthest + beyond + SAME_DEPTH;
}
