#version 300 es
// A thing smaller than a pixel, at rest or as the streak that it leaves while the shutter is open.
// In:  its light.   Out: radiance, cd/m², premultiplied by opacity; what glows has none.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/depth.glsl"

// What ends at a surface fades over this way before it, m.
const float SOFT = 0.01;

flat in vec4 vLight;    // radiance and opacity where it is thickest
flat in vec2 vStreak;   // from the middle of the point to the streak's end, pixels
flat in vec2 vExtent;   // breadth of the streak, size of the point, pixels

out vec4 oRadiance;

void main() {
  vec2 place = (gl_PointCoord - 0.5) * vec2(1.0, -1.0) * vExtent.y;
  float along = clamp(dot(place, vStreak) / max(dot(vStreak, vStreak), 1e-4), -1.0, 1.0);
  float away = length(place - along * vStreak) / vExtent.x;
  oRadiance = vLight * (max(1.0 - away, 0.0) * softParticleFade(SOFT));
}
