#version 300 es
// Mean self-occlusion of a normal map, by mip level: one texel a level.
// Out: visibility of the sky and of a light at 45 degrees, over that which the mip level itself accounts for.
#include "lib/precision.glsl"
#include "lib/normal-map.glsl"
#include "lib/relief.glsl"

uniform sampler2D uNormal;
uniform float uNormalScale;

const int TAPS = 1024;
const vec3 FLAT = vec3(0.0, 0.0, 1.0);

out vec4 oVisibility;

vec2 visibilityAt(vec2 uv, float level) {
  vec3 normal = tangentNormal(textureLod(uNormal, uv, level).xy, uNormalScale);
  float direct = 0.0;
  for (int i = 0; i < 4; i++) {
    float sign = i < 2 ? 1.0 : -1.0;
    vec3 toLight = vec3((i & 1) == 0 ? vec2(sign, 0.0) : vec2(0.0, sign), 1.0) * sqrt(0.5);
    direct += max(dot(normal, toLight), 0.0) * normalMapVisibility(FLAT, normal, toLight);
  }
  return vec2(skyVisibility(FLAT, normal), direct);
}

void main() {
  vec2 finest = vec2(0.0);
  vec2 level = vec2(0.0);
  for (int i = 0; i < TAPS; i++) {
    vec2 uv = fract(float(i) * vec2(0.7548776662, 0.5698402910));
    finest += visibilityAt(uv, 0.0);
    level += visibilityAt(uv, gl_FragCoord.x - 0.5);
  }
  oVisibility = vec4(min(finest / level, 1.0), 0.0, 1.0);
}
