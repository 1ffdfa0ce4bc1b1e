#version 300 es
// Point sprite smaller than a pixel, motion-blurred to a streak.
// Out: radiance, cd/m², premultiplied by opacity.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/depth.glsl"

// Width of the soft-particle fade, m.
const float FADE = 0.01;

flat in vec4 vLight;    // radiance and opacity at the centre
flat in vec2 vStreak;   // from the centre to the end of the streak, pixels
flat in vec2 vExtent;   // width of the streak, size of the point, pixels

out vec4 oRadiance;

void main() {
  vec2 offset = (gl_PointCoord - 0.5) * vec2(1.0, -1.0) * vExtent.y;
  float along = clamp(dot(offset, vStreak) / max(dot(vStreak, vStreak), 1e-4), -1.0, 1.0);
  float distance = length(offset - along * vStreak) / vExtent.x;
  oRadiance = vLight * (max(1.0 - distance, 0.0) * softParticleFade(FADE));
}
