#version 300 es
// What lies below the flame: a table's top, lit as nothing else in the room is, lights the candle on it.
// In:  patches that the flame sees.
// Out: radiosity at its foot of 1 cd, were the candle's shadow not there, lm/m²; its height, m.
#include "lib/precision.glsl"
#include "lib/photometry.glsl"
#include "lib/flame-light.glsl"
#include "lib/surfels.glsl"

uniform sampler2D uSurfelAlbedo;

out vec4 oBelow;

void main() {
  int size = textureSize(uSurfelNormalDistance, 0).y;
  ivec2 middle = surfelTexel(vec3(0.0, -1.0, 0.0), size);
  vec4 sum = vec4(0.0);
  float count = 0.0;
  for (int i = 0; i < 4; i++) {
    ivec2 texel = middle - ivec2(i & 1, i >> 1);
    Surfel surfel = surfelAt(texel, size);
    if (surfel.distance <= 0.0) continue;
    float facing = dot(surfel.normal, light.vantage - surfel.position) / surfel.distance;
    vec3 share = reflected(texelFetch(uSurfelAlbedo, texel, 0).rgb) * max(facing, 0.0);
    sum += vec4(share / (surfel.distance * surfel.distance), surfel.position.y);
    count++;
  }
  oBelow = sum / max(count, 1.0);
}
