#version 300 es
// The hot column over the flame as a ribbon that faces the eye, level by level.
#include "lib/precision.glsl"
#include "lib/frame.glsl"

// Half of the ribbon, in standard deviations of the column.
const float REACH = 3.0;

uniform vec4 uMiddle[LEVELS];  // of the column, m; breadth, m
#if BENDS
uniform float uBend[LEVELS];   // most that a ray is turned, rad
uniform vec2 uStrip;           // the picture's width over the strip's; twice the strip's left end over its width

out float vAcross;   // from the middle, in standard deviations
out float vBend;
out vec2 vSideways;  // on the screen, across the column
#endif

void main() {
  int level = gl_VertexID >> 1;
  vec4 middle = uMiddle[level];
  vec3 toEye = normalize(frame.eyePosition - middle.xyz);
  vec3 along = uMiddle[min(level + 1, LEVELS - 1)].xyz - uMiddle[max(level - 1, 0)].xyz;
  vec3 sideways = normalize(cross(along, toEye) + vec3(1e-6, 0.0, 0.0));
  float across = (gl_VertexID & 1) == 0 ? -REACH : REACH;
#if BENDS
  vAcross = across;
  vBend = uBend[level];
  vec4 centre = frame.clipFromWorld * vec4(middle.xyz, 1.0);
  vec4 aside = frame.clipFromWorld * vec4(middle.xyz + sideways * middle.w, 1.0);
  vec2 onScreen = (aside.xy / aside.w - centre.xy / centre.w) * frame.viewport;
  vSideways = onScreen / max(length(onScreen), 1e-4);
#endif
  gl_Position = frame.clipFromWorld * vec4(middle.xyz + sideways * (across * middle.w), 1.0);
#if BENDS
  // Only a strip of the picture is drawn: a viewport beyond the target would do, but makes Firefox warn.
  gl_Position.x = (gl_Position.x + gl_Position.w) * uStrip.x - gl_Position.w * (1.0 + uStrip.y);
#endif
}
