#version 300 es
// Display transform of the lone candle, with alpha for the page's background.
// In:  radiance, cd/m², premultiplied.   Out: display colour, premultiplied.
#include "lib/precision.glsl"
#include "lib/lone-display.glsl"

uniform sampler2D uRadiance;
uniform vec4 uGlare;  // centre of the light and its half height, uv; strength
uniform vec3 uGlareColor;

in vec2 vUv;

out vec4 oColor;

void main() {
  vec4 light = texelFetch(uRadiance, ivec2(gl_FragCoord.xy), 0);
  vec3 color = displayedColor(light);
  color += uGlareColor * glare(vUv, uGlare, 1.0) * (1.0 - color);
  oColor = overPage(color, light.a, gl_FragCoord.xy);
}
