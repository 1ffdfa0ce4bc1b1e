#version 300 es
// The hot column over the flame, as a camera-facing ribbon of one segment for each level.
#include "lib/precision.glsl"
#include "lib/frame.glsl"

// Half width of the ribbon, in standard deviations of the column.
const float REACH = 3.0;

uniform vec4 uColumn[LEVELS];  // centre, m; standard deviation, m
#if REFRACTS
uniform float uDeflection[LEVELS];  // largest angle of a ray, rad
uniform vec2 uStripTransform;  // the frame's width over the strip's; twice the strip's left edge over its width

out float vAcross;   // from the centre, in standard deviations
out float vDeflection;
out vec2 vSideways;  // on the screen, across the column
#endif

void main() {
  int level = gl_VertexID >> 1;
  vec4 centre = uColumn[level];
  vec3 toEye = normalize(frame.eyePosition - centre.xyz);
  vec3 along = uColumn[min(level + 1, LEVELS - 1)].xyz - uColumn[max(level - 1, 0)].xyz;
  vec3 sideways = normalize(cross(along, toEye) + vec3(1e-6, 0.0, 0.0));
  float across = (gl_VertexID & 1) == 0 ? -REACH : REACH;
#if REFRACTS
  vAcross = across;
  vDeflection = uDeflection[level];
  vec4 centreClip = frame.clipFromWorld * vec4(centre.xyz, 1.0);
  vec4 asideClip = frame.clipFromWorld * vec4(centre.xyz + sideways * centre.w, 1.0);
  vec2 onScreen = (asideClip.xy / asideClip.w - centreClip.xy / centreClip.w) * frame.viewport;
  vSideways = onScreen / max(length(onScreen), 1e-4);
#endif
  gl_Position = frame.clipFromWorld * vec4(centre.xyz + sideways * (across * centre.w), 1.0);
#if REFRACTS
  // Only a strip of the frame is drawn. A viewport larger than the target would do, but Firefox warns of it.
  gl_Position.x = (gl_Position.x + gl_Position.w) * uStripTransform.x - gl_Position.w * (1.0 + uStripTransform.y);
#endif
}
