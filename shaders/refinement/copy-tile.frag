#version 300 es
// A tile of the refined image, to its place.
// In and out: radiance per candela, depth.
#include "lib/precision.glsl"

uniform sampler2D uRadiance;
uniform sampler2D uDepth;
uniform vec2 uOrigin;  // of the tile, pixels

out vec4 oRadiance;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy - uOrigin);
  oRadiance = texelFetch(uRadiance, texel, 0);
  // Less than the cleared depth, or the test would reject it.
  gl_FragDepth = min(texelFetch(uDepth, texel, 0).r, 0.9999999);
}
