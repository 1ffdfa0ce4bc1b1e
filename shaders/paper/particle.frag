#version 300 es
// The paper's particle: a bright yellow-white centre, to orange and to blue at the rim, fading out.
// Colour also follows the height, to suggest temperature. Out: premultiplied.
#include "lib/precision.glsl"

const vec3 HOT = vec3(1.0, 0.90, 0.62);
const vec3 WARM = vec3(1.0, 0.62, 0.18);
const vec3 COOL = vec3(0.86, 0.22, 0.03);
const vec3 BLUE = vec3(0.08, 0.17, 0.62);
const vec3 UNIFORM_ORANGE = vec3(1.0, 0.5, 0.1);
// Where many particles lie on each other their light nears this multiple of a single one's colour:
// pure addition would clip to white wherever it is dense.
const float DENSITY_LIMIT = 1.25;

uniform float uGradient;  // 1 or 0
uniform float uHaze;      // 1: the haze layer, 0: the core
uniform float uGlow;      // light of one particle, display units

in float vAlpha;
in float vHeight;

out vec4 oColor;

vec3 core(float r) {
  vec3 body = mix(HOT, WARM, smoothstep(0.1, 0.8, r));
  vec3 byHeight = mix(body, COOL, smoothstep(0.45, 1.0, vHeight));
  return mix(byHeight, BLUE, 0.85 * smoothstep(0.14, -0.02, vHeight) * smoothstep(0.2, 0.8, r));
}

vec3 haze(float r) {
  vec3 body = mix(WARM, BLUE, smoothstep(0.15, 1.0, r) * 0.6);
  return mix(body, COOL, smoothstep(0.2, 0.9, vHeight));
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
  float glow = falloff * vAlpha * uGlow;
  oColor = vec4(color * glow, glow / DENSITY_LIMIT);
}
