#version 300 es
// The picture before, as it is seen from where the eye is now.
// In:  that picture, in its alpha what is carried; its depth.   Out: display colour.
#include "lib/precision.glsl"
#include "lib/gbuffer.glsl"
#include "lib/reproject.glsl"

uniform sampler2D uShown;
uniform sampler2D uDepth;

in vec2 vUv;

out vec4 oColor;

void main() {
  vec4 here = texture(uShown, vUv);
  float isHeld = carried(here.a);
  vec4 before = texture(uShown, previousUv(vec4(vUv, texture(uDepth, vUv).r, 1.0), isHeld));
  // What was hidden has nothing of its own in that picture: what stands there stays.
  oColor = mix(before, here, isDisoccluded(isHeld, before.a));
}
