#version 300 es
// Point sprite of a particle of the paper's flame, advanced and coloured by height, which suggests temperature.
#include "particles/kernel.glsl"

const vec3 HOT = vec3(1.0, 0.90, 0.62);
const vec3 WARM = vec3(1.0, 0.62, 0.18);
const vec3 COOL = vec3(0.86, 0.22, 0.03);
const vec3 BLUE = vec3(0.08, 0.17, 0.62);
const vec3 UNIFORM_ORANGE = vec3(1.0, 0.5, 0.1);
// Limit of the sum of many overlapping particles, as a multiple of one's colour: plain addition would clip to white.
const float DENSITY_LIMIT = 1.25;

uniform mat4 uClipFromFlame;  // from the emitter's unit
uniform float uSize;          // diameter at birth, pixels at a distance of 1 m
uniform float uExtrapolation; // s from the last tick to the frame
uniform float uFading;        // 1 or 0: light and size shrink with the remaining life
uniform float uGlow;          // light of one particle, display units

// Premultiplied.
flat out vec4 vCentre;
flat out vec4 vRim;

#if GRADIENT
// The gradient also fades out, so the rim's colour overshoots to give the sprite the right mean.
void shade(float height, float glow) {
#if HAZE
  float cooled = smoothstep(0.2, 0.9, height);
  vec3 centre = mix(WARM, COOL, cooled);
  vec3 rim = mix(mix(WARM, BLUE, 0.51), COOL, cooled);
#else
  float cooled = smoothstep(0.45, 1.0, height);
  vec3 centre = mix(HOT, COOL, cooled);
  vec3 warm = mix(WARM, COOL, cooled);
  vec3 rim = mix(centre, warm, 1.27);
  rim += smoothstep(0.14, -0.02, height) * (BLUE - mix(centre, warm, 0.78));
#endif
  vCentre = vec4(centre, 1.0 / DENSITY_LIMIT) * glow;
  vRim = vec4(rim, 1.0 / DENSITY_LIMIT) * glow;
}
#else
void shade(float height, float glow) {
  vCentre = vec4(UNIFORM_ORANGE, 1.0) * glow;
  vRim = vCentre;
}
#endif

void main() {
  moveParticle();
  float remainingNow = remaining - uExtrapolation;
  if (remainingNow <= 0.0) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // dead: outside of the frustum
    gl_PointSize = 1.0;
    return;
  }
  float share = mix(1.0, remainingNow / layer.life, uFading);
  vec3 extrapolated = position + velocity * uExtrapolation;
  shade(extrapolated.y, share * uGlow);
  gl_Position = uClipFromFlame * vec4(extrapolated, 1.0);
  gl_PointSize = uSize * share / gl_Position.w;
}
