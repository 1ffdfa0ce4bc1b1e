#version 300 es
// A shiny surface with ripples three pixels wide, in sixteen tiles that lie a sixteenth of a pixel apart.
// Out: radiance as the relief widens the highlight; as if it did not; as 256 points of the pixel have it.
#include "lib/precision.glsl"
#include "lib/brdf.glsl"
#include "lib/environment-brdf.glsl"

in vec2 vUv;

out vec4 oRadiance;

const float TILE = 16.0;
const float ALPHA = 0.01;
const float STEEPNESS = 0.2;

vec3 rippled(vec2 pixel) {
  vec2 slope = STEEPNESS * cos(2.0 * PI * pixel / vec2(3.1, 4.7));
  return normalize(vec3(slope, 1.0));
}

float shine(vec3 normal, float alpha) {
  const vec3 VIEW = vec3(0.0, 0.0, 1.0);
  vec3 L = normalize(vec3(0.2, 0.1, 1.0));
  vec3 H = normalize(L + VIEW);
  float NoL = max(dot(normal, L), 0.0);
  return distributionGgx(alpha, max(dot(normal, H), 0.0)) * visibilitySmith(alpha, normal.z, NoL) * NoL;
}

void main() {
  vec2 tile = floor(gl_FragCoord.xy / TILE);
  vec2 pixel = gl_FragCoord.xy - tile * TILE + vec2(tile.x + 4.0 * tile.y) / 16.0;
  vec3 normal = rippled(pixel);
  float truth = 0.0;
  for (int i = 0; i < 256; i++) {
    vec2 within = (vec2(i & 15, i >> 4) + 0.5) / 16.0 - 0.5;
    truth += shine(rippled(pixel + within), ALPHA) / 256.0;
  }
  oRadiance = vec4(shine(normal, specularAntialiasing(ALPHA, normal)), shine(normal, ALPHA), truth, 1.0);
}
