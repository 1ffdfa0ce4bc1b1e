#version 300 es
// Luminous flux that each virtual light reflects: that of its group of the moon's surfels, for 1 lx.
// Out: lm.
#include "lib/precision.glsl"
#include "lib/photometry.glsl"
#include "lib/moon.glsl"
#include "lib/surfels.glsl"

uniform sampler2D uRadiosity;  // lm/m²
uniform sampler2D uGroups;     // number of each surfel's light, of 255

out vec4 oFlux;

void main() {
  ivec2 size = textureSize(uGroups, 0);
  int light = int(gl_FragCoord.x);
  float sum = 0.0;
  for (int y = 0; y < size.y; y++) {
    for (int x = 0; x < size.x; x++) {
      ivec2 texel = ivec2(x, y);
      if (int(texelFetch(uGroups, texel, 0).r * 255.0 + 0.5) != light) continue;
      sum += luma(texelFetch(uRadiosity, texel, 0).rgb) * surfelAt(texel, size.y).area;
    }
  }
  oFlux = vec4(sum, 0.0, 0.0, 1.0);
}
