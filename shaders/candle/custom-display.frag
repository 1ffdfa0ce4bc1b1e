#version 300 es
// Display transform of a visitor's own candles, with alpha for the page's background.
// In:  radiance, cd/m², premultiplied.   Out: display colour, premultiplied.
#include "lib/precision.glsl"
#include "lib/lone-display.glsl"
#include "lib/candle-flames.glsl"

uniform sampler2D uRadiance;
uniform vec3 uGlareColor;
uniform float uMagnification;  // of a taper alone, over this frame's
uniform float uHighlights;     // stops above white, as a multiple of those at this exposure

in vec2 vUv;

out vec4 oColor;

// Flames bleach to the same gold at every exposure: what is far above white is as far above it as a taper's flame is.
vec3 raisedHighlights(vec3 radiance) {
  float peak = max(max(radiance.r, radiance.g), radiance.b) * frame.exposure;
  return peak > 1.0 ? radiance * pow(peak, uHighlights - 1.0) : radiance;
}

void main() {
  vec4 light = texture(uRadiance, vUv);
  light.rgb = raisedHighlights(light.rgb);
  vec3 color = displayedColor(light);
  for (int i = 0; i < int(flames.count); i++) {
    color += uGlareColor * glare(vUv, flames.glares[i], uMagnification) * (1.0 - color);
  }
  oColor = overPage(color, light.a, gl_FragCoord.xy);
}
