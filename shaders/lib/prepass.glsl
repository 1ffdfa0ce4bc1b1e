// What a depth prepass tells of a fragment of the refined image: a software renderer shades what depth then hides.

uniform highp sampler2D uPrepassDepth;  // of the frame, one sample a pixel
uniform sampler2D uShadedOnce;          // radiance per candela with one sample a pixel, moonlight included
uniform float uIsMultisampled;          // 1 or 0: whether a pixel has several samples now
uniform float uIsShadedOnce;            // 1 or 0: whether that was in the same light

// Depths on one surface differ by rounding: a millimetre at 3 m.
const float SAME_DEPTH = 1e-6;

const int HIDDEN = 0;
const int VISIBLE = 1;
const int FILLS_PIXEL = 2;  // alone, so that one sample was enough

int coverageAt(ivec2 pixel) {
  float depth = gl_FragCoord.z;
  vec2 slope = vec2(dFdx(depth), dFdy(depth));
  ivec2 end = textureSize(uPrepassDepth, 0) - 1;
  int reach = uIsMultisampled > 0.5 ? 1 : 0;
  float farthest = 0.0;
  bool isPlane = uIsShadedOnce > 0.5;
  for (int y = -reach; y <= reach; y++) {
    for (int x = -reach; x <= reach; x++) {
      float nearest = texelFetch(uPrepassDepth, clamp(pixel + ivec2(x, y), ivec2(0), end), 0).r;
      farthest = max(farthest, nearest);
      isPlane = isPlane && abs(nearest - depth - dot(slope, vec2(x, y))) < SAME_DEPTH;
    }
  }
  // In a corner between two planes, that of a sample may lie behind both at the pixel's centre.
  float beyond = float(reach) * (abs(slope.x) + abs(slope.y));
  return depth > farthest + beyond + SAME_DEPTH ? HIDDEN : isPlane ? FILLS_PIXEL : VISIBLE;
}
