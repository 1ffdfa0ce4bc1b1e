#version 300 es
// The paper's particle: a bright yellow-white centre, to orange and to blue at the rim, fading out.
// Colour also follows the height, to suggest temperature. Out: premultiplied; alpha 0 adds.
#include "lib/precision.glsl"

const vec3 HOT = vec3(1.0, 0.86, 0.52);
const vec3 WARM = vec3(1.0, 0.46, 0.10);
const vec3 COOL = vec3(0.62, 0.14, 0.02);
const vec3 BLUE = vec3(0.12, 0.25, 0.95);
const vec3 UNIFORM_ORANGE = vec3(1.0, 0.5, 0.1);

uniform float uGradient;  // 1 or 0
uniform float uHaze;      // 1: the haze layer, 0: the core
uniform float uGlow;      // light of one particle, display units

in float vAlpha;
in float vHeight;

out vec4 oColor;

vec3 core(float r) {
  vec3 body = mix(HOT, WARM, smoothstep(0.0, 0.9, r));
  vec3 byHeight = mix(body, COOL, smoothstep(0.45, 1.0, vHeight));
  return mix(byHeight, BLUE, smoothstep(0.12, -0.08, vHeight) * smoothstep(0.1, 0.9, r));
}

vec3 haze(float r) {
  vec3 body = mix(WARM, BLUE, smoothstep(0.15, 1.0, r) * 0.6);
  return mix(body, COOL, smoothstep(0.3, 1.0, vHeight));
}

void main() {
  float r = length(gl_PointCoord * 2.0 - 1.0);
  if (r >= 1.0) discard;
  if (uGradient < 0.5) {
    oColor = vec4(UNIFORM_ORANGE, 1.0) * (uHaze > 0.5 ? 0.08 : 0.8) * vAlpha;
    return;
  }
  float falloff = (1.0 - r * r) * (1.0 - r * r);
  vec3 color = uHaze > 0.5 ? haze(r) : core(r);
  oColor = vec4(color * (falloff * vAlpha * uGlow), 0.0);
}
