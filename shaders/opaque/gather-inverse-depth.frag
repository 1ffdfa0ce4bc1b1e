#version 300 es
// Inverse depth of four neighbouring lighting texels in one: one tap for the bilateral upsampling instead of five.
// In:  inverse depth.   Out: that of the texel, of its right, its upper and its upper right neighbour.
#include "lib/precision.glsl"

uniform sampler2D uInverseDepth;

out vec4 oGathered;

void main() {
  ivec2 low = ivec2(gl_FragCoord.xy);
  ivec2 high = min(low + 1, textureSize(uInverseDepth, 0) - 1);
  oGathered = vec4(
    texelFetch(uInverseDepth, low, 0).r,
    texelFetch(uInverseDepth, ivec2(high.x, low.y), 0).r,
    texelFetch(uInverseDepth, ivec2(low.x, high.y), 0).r,
    texelFetch(uInverseDepth, high, 0).r
  );
}
