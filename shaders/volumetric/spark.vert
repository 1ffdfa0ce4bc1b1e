#version 300 es
// A droplet of burning wax, moved and drawn as the streak that an open shutter makes of it.
#include "particles/kernel.glsl"
#include "lib/frame.glsl"

// s
const float SHUTTER = 1.0 / 60.0;
const float BREADTH = 1.1;   // pixels
const float LONGEST = 60.0;  // pixels

uniform vec4 uEmitter;       // m; metres per unit of the layer
uniform float uSize;         // diameter, m
uniform float uAhead;        // s that the picture is ahead of the last tick
uniform vec3 uGlow[GLOWS];   // radiance from birth to death, cd/m²

flat out vec4 vLight;
flat out vec2 vStreak;
flat out vec2 vExtent;

vec2 onScreen(vec4 clip) {
  return clip.xy / max(clip.w, 1e-3) * 0.5 * frame.viewport;
}

void main() {
  moveParticle();
  vec3 place = uEmitter.xyz + (position + velocity * uAhead) * uEmitter.w;
  float age = (1.0 - max(remaining - uAhead, 0.0) / layer.life) * float(GLOWS - 1);
  int level = int(min(age, float(GLOWS - 2)));
  vec3 glow = mix(uGlow[level], uGlow[level + 1], age - float(level));
  vec4 head = frame.clipFromWorld * vec4(place, 1.0);
  vec4 tail = frame.clipFromWorld * vec4(place - velocity * (SHUTTER * uEmitter.w), 1.0);
  vec2 way = onScreen(head) - onScreen(tail);
  float streak = min(length(way), LONGEST);
  vStreak = 0.5 * way * (streak / max(length(way), 1e-3));
  float breadth = uSize * frame.projectionScale / max(head.w, 1e-3);
  // All of its light, spread over all that it passed.
  float share = min(breadth * breadth / (BREADTH * (BREADTH + streak)), 1.0);
  vLight = vec4(glow * share, 0.0);
  vExtent = vec2(BREADTH, streak + 2.0 * BREADTH + 1.0);
  gl_PointSize = vExtent.y;
  bool isSeen = remaining > uAhead && head.w > 0.05 && tail.w > 0.05;
  gl_Position = isSeen ? (head + tail * (head.w / tail.w)) * 0.5 : vec4(2.0, 2.0, 2.0, 1.0);
}
