#version 300 es
// One particle of the paper's flame as a point sprite, sized in metres.
#include "lib/precision.glsl"
#include "lib/frame.glsl"

layout(location = 0) in vec4 aPositionLife;  // emitter's unit; life: seconds left
layout(location = 1) in vec4 aVelocitySpan;  // span: life at birth, s

uniform vec4 uWorldFromFlame;  // emitter, m; w: metres per unit
uniform float uAhead;          // s that the picture is ahead of the last tick
uniform float uSize;           // diameter at birth, m
uniform float uFading;         // 1 or 0: alpha and size shrink with remaining life

out float vAlpha;
out float vHeight;  // above the emitter, in its unit

void main() {
  float remaining = aPositionLife.w - uAhead;
  if (remaining <= 0.0) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // outside of the view: dead
    gl_PointSize = 1.0;
    return;
  }
  float share = remaining / aVelocitySpan.w;
  vec3 position = aPositionLife.xyz + aVelocitySpan.xyz * uAhead;
  vAlpha = uFading > 0.5 ? share : 1.0;
  vHeight = position.y;
  gl_Position = frame.clipFromWorld * vec4(uWorldFromFlame.xyz + position * uWorldFromFlame.w, 1.0);
  gl_PointSize = uSize * (uFading > 0.5 ? share : 1.0) * frame.projectionScale / gl_Position.w;
}
