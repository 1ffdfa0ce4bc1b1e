#version 300 es
// A tile of the refined image, to its place; or all that it begins with.
// In and out: radiance per candela, depth. In: moonlight in alpha, which is counted as the flame's from now on.
#include "lib/precision.glsl"

uniform sampler2D uRadiance;
uniform sampler2D uDepth;
uniform vec2 uOrigin;      // of the tile, pixels
uniform vec3 uFlamelight;  // factor on what comes from flames: 0 where all are out
uniform vec3 uMoonlight;   // lx, for 1 cd

out vec4 oRadiance;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy - uOrigin);
  vec4 perUnit = texelFetch(uRadiance, texel, 0);
  oRadiance = vec4(perUnit.rgb * uFlamelight + perUnit.a * uMoonlight, 1.0);
  // Less than the cleared depth, or the test would reject it.
  gl_FragDepth = min(texelFetch(uDepth, texel, 0).r, 0.9999999);
}
