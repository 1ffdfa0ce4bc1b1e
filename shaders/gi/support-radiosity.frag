#version 300 es
// Radiosity of the candle's support, the brightest surface of the room: mean of the surfels below the flame.
// Out: radiosity at the candle's foot for 1 cd, without the candle's shadow, lm/m²; height of the support, m.
#include "lib/precision.glsl"
#include "lib/flame-light.glsl"
#include "lib/surfels.glsl"

uniform sampler2D uSurfelReflectance;

out vec4 oSupport;

void main() {
  int size = textureSize(uSurfelNormalDistance, 0).y;
  ivec2 centre = ivec2(3 * size, 0) + size / 2;  // of the face below
  vec4 sum = vec4(0.0);
  float count = 0.0;
  for (int i = 0; i < 4; i++) {
    ivec2 texel = centre - ivec2(i & 1, i >> 1);
    Surfel surfel = surfelAt(texel, size);
    if (surfel.distance <= 0.0) continue;
    float cosine = dot(surfel.normal, light.captureOrigin - surfel.position) / surfel.distance;
    vec3 radiosity = texelFetch(uSurfelReflectance, texel, 0).rgb * max(cosine, 0.0);
    sum += vec4(radiosity / (surfel.distance * surfel.distance), surfel.position.y);
    count++;
  }
  oSupport = sum / max(count, 1.0);
}
