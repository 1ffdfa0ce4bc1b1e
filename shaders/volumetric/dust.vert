#version 300 es
// A mote of dust in the flame's light, moved and drawn.
#include "particles/kernel.glsl"
#include "lib/frame.glsl"
#include "lib/octahedral.glsl"
#include "lib/photometry.glsl"
#include "lib/flame-light.glsl"
#include "lib/irradiance-volume.glsl"
#include "lib/scattering.glsl"

// Breadth that it is drawn with, pixels: the fainter for it.
const float BREADTH = 1.2;
// Too near to the eye to be seen sharp, m.
const vec2 BLURRED = vec2(0.12, 0.3);

uniform vec4 uEmitter;  // m; metres per unit of the layer
uniform float uSize;    // diameter, m
uniform float uAhead;   // s that the picture is ahead of the last tick

flat out vec4 vLight;
flat out vec2 vStreak;
flat out vec2 vExtent;

void main() {
  moveParticle();
  vec3 place = uEmitter.xyz + (position + velocity * uAhead) * uEmitter.w;
  float age = 1.0 - (remaining - uAhead) / layer.life;
  // No mote comes or goes at once.
  float shown = smoothstep(0.0, 0.35, age) * smoothstep(1.0, 0.65, age) * float(remaining > 0.0);
  float away = max(distance(place, frame.eyePosition), 1e-3);
  float breadth = uSize * (0.5 + unit(pcg(slot))) * frame.projectionScale / away;
  float opacity = min(breadth * breadth / (BREADTH * BREADTH), 1.0);
  opacity *= shown * smoothstep(BLURRED.x, BLURRED.y, away);
  vLight = vec4(scatteredRadiance(place, frame.eyePosition), 1.0) * opacity;
  vStreak = vec2(0.0);
  vExtent = vec2(BREADTH, 2.0 * BREADTH + 1.0);
  gl_PointSize = vExtent.y;
  gl_Position = opacity > 0.0 ? frame.clipFromWorld * vec4(place, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
