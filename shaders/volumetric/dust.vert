#version 300 es
// A dust particle in the flame's light, advanced and drawn.
#include "volumetric/mote.glsl"
#include "lib/photometry.glsl"
#include "lib/flame-light.glsl"
#include "lib/irradiance-volume.glsl"
#include "lib/scattering.glsl"

// Width of the sprite, pixels; a smaller particle is drawn fainter.
const float WIDTH = 1.2;
// Distances from the eye over which a particle fades in, m: nearer ones would be out of focus.
const vec2 NEAR_FADE = vec2(0.12, 0.3);

void main() {
  moveParticle();
  vec3 positionWorld = extrapolatedPosition();
  float age = 1.0 - (remaining - uExtrapolation) / layer.life;
  float fade = smoothstep(0.0, 0.35, age) * smoothstep(1.0, 0.65, age) * float(remaining > 0.0);
  float distance_ = max(distance(positionWorld, frame.eyePosition), 1e-3);
  float width = uSize * (0.5 + unit(pcg(slot))) * frame.projectionScale / distance_;
  float opacity = min(width * width / (WIDTH * WIDTH), 1.0);
  opacity *= fade * smoothstep(NEAR_FADE.x, NEAR_FADE.y, distance_);
  // Below the largest half float, as in spark.vert.
  vec3 light = scatteredRadiance(positionWorld, frame.eyePosition, 1.0) * opacity;
  light *= min(1.0, 3e4 / max(light.r, 1e-6));
  vLight = vec4(light, max(opacity, light.r / 6e4));
  vStreak = vec2(0.0);
  vExtent = vec2(WIDTH, 2.0 * WIDTH + 1.0);
  gl_PointSize = vExtent.y;
  gl_Position = opacity > 0.0 ? frame.clipFromWorld * vec4(positionWorld, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
