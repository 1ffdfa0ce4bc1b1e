#version 300 es
// Display transform of a visitor's own candles, with alpha for the page's background.
// In:  radiance, cd/m², premultiplied.   Out: display colour, premultiplied.
#include "lib/precision.glsl"
#include "lib/lone-display.glsl"
#include "lib/candle-flames.glsl"

uniform sampler2D uRadiance;
uniform vec3 uGlareColor;
uniform float uMagnification;  // of a taper alone, over this frame's

in vec2 vUv;

out vec4 oColor;

void main() {
  vec4 light = texture(uRadiance, vUv);
  vec3 color = displayedColor(light);
  for (int i = 0; i < int(flames.count); i++) {
    color += uGlareColor * glare(vUv, flames.glares[i], uMagnification) * (1.0 - color);
  }
  oColor = overPage(color, light.a, gl_FragCoord.xy);
}
