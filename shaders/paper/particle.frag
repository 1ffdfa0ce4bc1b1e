#version 300 es
// The paper's particle: radial gradient from a yellow-white centre to an orange or blue rim.
// Out: display colour, premultiplied.
#include "lib/precision.glsl"

flat in vec4 vCentre;
flat in vec4 vRim;

out vec4 oColor;

void main() {
  vec2 offset = gl_PointCoord * 2.0 - 1.0;
  float inside = 1.0 - dot(offset, offset);
  if (inside <= 0.0) discard;
#if GRADIENT
  float falloff = inside * inside;
  oColor = mix(vRim, vCentre, falloff) * falloff;
#else
  oColor = vCentre;
#endif
}
