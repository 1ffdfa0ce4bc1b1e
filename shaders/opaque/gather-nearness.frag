#version 300 es
// What lib/upsample-bilateral.glsl compares, together: one tap instead of five for each pixel of the picture.
// In:  how near each texel of the light is.
// Out: the same of the texel, of the one beside it, of the one above it, and of the one above that.
#include "lib/precision.glsl"

uniform sampler2D uNearness;

out vec4 oCorners;

void main() {
  ivec2 low = ivec2(gl_FragCoord.xy);
  ivec2 high = min(low + 1, textureSize(uNearness, 0) - 1);
  oCorners = vec4(
    texelFetch(uNearness, low, 0).r,
    texelFetch(uNearness, ivec2(high.x, low.y), 0).r,
    texelFetch(uNearness, ivec2(low.x, high.y), 0).r,
    texelFetch(uNearness, high, 0).r
  );
}
