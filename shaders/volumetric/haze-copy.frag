#version 300 es
// The same pixel of another picture.
#include "lib/precision.glsl"

uniform sampler2D uSource;
uniform vec2 uCorner;  // of the other picture in this one, pixels

out vec4 oRadiance;

void main() {
  oRadiance = texelFetch(uSource, ivec2(gl_FragCoord.xy - uCorner), 0);
}
