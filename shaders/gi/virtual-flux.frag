#version 300 es
// Luminous flux of each virtual light: that of its group of the moon's surfels, for 1 lx.
// Out: first row: what it scatters, or of panes what they let through, lm; second: what falls on dielectrics, lm, and
// their mean gloss.
#include "lib/precision.glsl"
#include "lib/photometry.glsl"
#include "lib/moon.glsl"
#include "lib/surfels.glsl"
#include "lib/reflectance.glsl"

uniform sampler2D uRadiosity;  // lm/m²
uniform sampler2D uGroups;     // number of each surfel's light, of 255

out vec4 oFlux;

void main() {
  ivec2 size = textureSize(uGroups, 0);
  int light = int(gl_FragCoord.x);
  vec3 scattered = vec3(0.0);
  vec2 mirrored = vec2(0.0);
  for (int y = 0; y < size.y; y++) {
    for (int x = 0; x < size.x; x++) {
      ivec2 texel = ivec2(x, y);
      if (int(texelFetch(uGroups, texel, 0).r * 255.0 + 0.5) != light) continue;
      Surfel surfel = surfelAt(texel, size.y);
      vec4 radiosity = texelFetch(uRadiosity, texel, 0);
      float gloss = -radiosity.a;
      float incident = gloss > 0.0 ? surfel.solidAngle : 0.0;
      float specular = incident * specularReflectance(sqrt(max(1.0 - gloss, 0.0)));
      scattered += max(radiosity.rgb * surfel.area - specular, 0.0);
      mirrored += incident * vec2(1.0, gloss);
    }
  }
  bool isFirstRow = gl_FragCoord.y < 1.0;
  oFlux = isFirstRow ? vec4(scattered, 1.0) : vec4(mirrored.x, mirrored.y / max(mirrored.x, 1e-9), 0.0, 1.0);
}
