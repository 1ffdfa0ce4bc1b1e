#version 300 es
// Benchmark load: shadow taps on a cube of half floats.
#include "lib/precision.glsl"
#include "lib/random.glsl"

const int TAPS = 32;

uniform samplerCube uTexture;

out vec4 oSum;

void main() {
  float texels = 0.5 * float(textureSize(uTexture, 0).x);
  uint chance = pcg(uint(gl_FragCoord.x) + pcg(uint(gl_FragCoord.y)));
  float sum = 0.0;
  for (int i = 0; i < TAPS; i++) {
    uvec2 turn = uvec2(uint(i) * 3242174889u, uint(i) * 2447445414u) + chance;
    vec2 uv = vec2(turn >> 8) / 8388608.0 - 1.0;
    vec3 direction = vec3(uv, 0.5 + 0.001 * sum);
    vec3 reach = abs(direction);
    float most = max(max(reach.x, reach.y), reach.z);
    vec3 onFace = direction / most;
    vec3 middle = (floor(onFace * texels) + 0.5) / texels;
    vec3 tap = mix(middle, onFace, vec3(greaterThanEqual(reach, vec3(most))));
    sum += step(length(tap) * 0.8, textureLod(uTexture, tap, 0.0).r);
  }
  oSum = vec4(sum / float(TAPS));
}
