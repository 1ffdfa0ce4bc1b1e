#version 300 es
// What relief hides of light where a picture of it is too coarse to show it, by how coarse: a texel a level.
// Out: share of light from all around, and of light at 45 degrees, of what the coarser normals would take.
#include "lib/precision.glsl"
#include "lib/normal-map.glsl"

uniform sampler2D uNormal;
uniform float uRelief;  // scale of the normals

const int TAPS = 1024;
const vec3 FLAT = vec3(0.0, 0.0, 1.0);

out vec4 oShares;

vec2 taken(vec2 place, float level) {
  vec2 slope = textureLod(uNormal, place, level).xy * 2.0 - 1.0;
  vec3 relief = vec3(slope, sqrt(max(1.0 - dot(slope, slope), 0.0)));
  vec3 normal = normalize(mix(FLAT, relief, uRelief));
  float direct = 0.0;
  for (int i = 0; i < 4; i++) {
    float sign = i < 2 ? 1.0 : -1.0;
    vec3 toLight = vec3((i & 1) == 0 ? vec2(sign, 0.0) : vec2(0.0, sign), 1.0) * sqrt(0.5);
    direct += max(dot(normal, toLight), 0.0) * normalMapVisibility(FLAT, normal, toLight);
  }
  return vec2(skyVisibility(FLAT, normal), direct);
}

void main() {
  vec2 fine = vec2(0.0);
  vec2 coarse = vec2(0.0);
  for (int i = 0; i < TAPS; i++) {
    vec2 place = fract(float(i) * vec2(0.7548776662, 0.5698402910));
    fine += taken(place, 0.0);
    coarse += taken(place, gl_FragCoord.x - 0.5);
  }
  oShares = vec4(min(fine / coarse, 1.0), 0.0, 1.0);
}
