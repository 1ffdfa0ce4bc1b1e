#version 300 es
// Benchmark load: shadow taps on a cube of half floats; GRAZING: anisotropic taps on a plain texture.
#include "lib/precision.glsl"
#include "lib/random.glsl"

const int TAPS = 32;

#if GRAZING
const float LENGTH = 8.0;  // of a footprint, texels; its width is one

uniform sampler2D uTexture;
#else
uniform samplerCube uTexture;
#endif

out vec4 oSum;

void main() {
#if GRAZING
  vec2 texel = 1.0 / vec2(textureSize(uTexture, 0));
#else
  float texels = 0.5 * float(textureSize(uTexture, 0).x);
#endif
  uint chance = pcg(uint(gl_FragCoord.x) + pcg(uint(gl_FragCoord.y)));
  vec4 sum = vec4(0.0);
  for (int i = 0; i < TAPS; i++) {
    uvec2 turn = uvec2(uint(i) * 3242174889u, uint(i) * 2447445414u) + chance;
    vec2 uv = vec2(turn >> 8) / 8388608.0 - 1.0;
#if GRAZING
    sum += textureGrad(uTexture, uv, vec2(LENGTH * texel.x, 0.0), vec2(0.0, texel.y));
#else
    vec3 direction = vec3(uv, 0.5 + 0.001 * sum.x);
    vec3 reach = abs(direction);
    float most = max(max(reach.x, reach.y), reach.z);
    vec3 onFace = direction / most;
    vec3 middle = (floor(onFace * texels) + 0.5) / texels;
    vec3 tap = mix(middle, onFace, vec3(greaterThanEqual(reach, vec3(most))));
    sum.x += step(length(tap) * 0.8, textureLod(uTexture, tap, 0.0).r);
#endif
  }
  oSum = sum / float(TAPS);
}
