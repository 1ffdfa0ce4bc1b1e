#version 300 es
// A spark, a droplet of burning wax: advanced and drawn as a motion-blurred streak.
#include "volumetric/mote.glsl"

const float SHUTTER = 1.0 / 60.0;  // s
const float WIDTH = 1.1;           // pixels
const float LONGEST = 60.0;        // pixels

uniform vec3 uGlow[GLOWS];   // radiance from birth to death, cd/m²

vec2 onScreen(vec4 clip) {
  return clip.xy / max(clip.w, 1e-3) * 0.5 * frame.viewport;
}

void main() {
  moveParticle();
  vec3 positionWorld = extrapolatedPosition();
  float age = (1.0 - max(remaining - uExtrapolation, 0.0) / layer.life) * float(GLOWS - 1);
  int level = int(min(age, float(GLOWS - 2)));
  vec3 glow = mix(uGlow[level], uGlow[level + 1], age - float(level));
  vec4 head = frame.clipFromWorld * vec4(positionWorld, 1.0);
  vec4 tail = frame.clipFromWorld * vec4(positionWorld - velocity * (SHUTTER * uEmitter.w), 1.0);
  vec2 motion = onScreen(head) - onScreen(tail);
  float streak = min(length(motion), LONGEST);
  vStreak = 0.5 * motion * (streak / max(length(motion), 1e-3));
  float width = uSize * frame.projectionScale / max(head.w, 1e-3);
  // The droplet's light is spread over the area of its streak.
  float share = min(width * width / (WIDTH * (WIDTH + streak)), 1.0);
  // Below the largest half float, 65504, also before flames, as in flame.frag. Red is the largest.
  vec3 light = glow * share;
  light *= min(1.0, 3e4 / max(light.r, 1e-6));
  vLight = vec4(light, light.r / 6e4);
  vExtent = vec2(WIDTH, streak + 2.0 * WIDTH + 1.0);
  gl_PointSize = vExtent.y;
  bool isVisible = remaining > uExtrapolation && head.w > 0.05 && tail.w > 0.05;
  gl_Position = isVisible ? (head + tail * (head.w / tail.w)) * 0.5 : vec4(2.0, 2.0, 2.0, 1.0);
}
