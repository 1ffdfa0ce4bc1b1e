#version 300 es
// The same pixel of another picture.
#include "lib/precision.glsl"

uniform sampler2D uSource;

out vec4 oRadiance;

void main() {
  oRadiance = texelFetch(uSource, ivec2(gl_FragCoord.xy), 0);
}
