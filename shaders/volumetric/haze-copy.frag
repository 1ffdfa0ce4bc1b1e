#version 300 es
// Copies a refracted strip back onto the frame.
#include "lib/precision.glsl"

uniform sampler2D uSource;
uniform vec2 uStripOrigin;  // of the strip in the frame, pixels

out vec4 oRadiance;

void main() {
  oRadiance = texelFetch(uSource, ivec2(gl_FragCoord.xy - uStripOrigin), 0);
}
