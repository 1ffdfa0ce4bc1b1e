#version 300 es
// Reprojection of the history buffer: previous frame's colour -> current frame.
// In:  previous display colour, alpha telling what is held; depth.   Out: display colour.
#include "lib/precision.glsl"
#include "lib/gbuffer.glsl"
#include "lib/reproject.glsl"

uniform sampler2D uHistory;
uniform sampler2D uDepth;

in vec2 vUv;

out vec4 oColor;

void main() {
  vec4 center = texture(uHistory, vUv);
  float isHeld = isHeldSurface(center.a);
  vec4 previous = texture(uHistory, previousUv(vec4(vUv, texture(uDepth, vUv).r, 1.0), isHeld));
  // A disocclusion has no colour in the history: it keeps the previous colour of the pixel.
  oColor = mix(previous, center, isDisoccluded(isHeld, previous.a));
}
