#version 300 es
// Display transform of a visitor's own candles, with alpha for the page's background.
// LIGHTS: number of images of the surfaces that are kept; they are behind the radiance.
// In:  radiance, cd/m², premultiplied.   Out: display colour, premultiplied.
#include "lib/precision.glsl"
#include "lib/lone-display.glsl"
#include "lib/candle-flames.glsl"

uniform sampler2D uRadiance;
uniform vec3 uGlareColor;
uniform float uMagnification;  // of a taper alone, over this frame's
uniform float uHighlights;     // stops above white, as a multiple of those at this exposure

#ifdef LIGHTS
uniform vec3 uScales[LIGHTS];  // of each image, which is of one light; the first has the surfaces' alpha
uniform sampler2D uLight0;
uniform sampler2D uLight1;
uniform sampler2D uLight2;
#if LIGHTS > 3
uniform sampler2D uLight3;
#endif
#if LIGHTS > 4
uniform sampler2D uLight4;
#endif
#if LIGHTS > 5
uniform sampler2D uLight5;
#endif
#if LIGHTS > 6
uniform sampler2D uLight6;
#endif
#if LIGHTS > 7
uniform sampler2D uLight7;
#endif

vec4 surfaces(vec2 uv) {
  vec4 sum = texture(uLight0, uv) * vec4(uScales[0], 1.0);
  sum.rgb += texture(uLight1, uv).rgb * uScales[1] + texture(uLight2, uv).rgb * uScales[2];
#if LIGHTS > 3
  sum.rgb += texture(uLight3, uv).rgb * uScales[3];
#endif
#if LIGHTS > 4
  sum.rgb += texture(uLight4, uv).rgb * uScales[4];
#endif
#if LIGHTS > 5
  sum.rgb += texture(uLight5, uv).rgb * uScales[5];
#endif
#if LIGHTS > 6
  sum.rgb += texture(uLight6, uv).rgb * uScales[6];
#endif
#if LIGHTS > 7
  sum.rgb += texture(uLight7, uv).rgb * uScales[7];
#endif
  return sum;
}
#endif

in vec2 vUv;

out vec4 oColor;

// Flames bleach to the same gold at every exposure: what is far above white is as far above it as a taper's flame is.
vec3 raisedHighlights(vec3 radiance) {
  float peak = max(max(radiance.r, radiance.g), radiance.b) * frame.exposure;
  return peak > 1.0 ? radiance * pow(peak, uHighlights - 1.0) : radiance;
}

void main() {
  vec4 light = texelFetch(uRadiance, ivec2(gl_FragCoord.xy), 0);
#ifdef LIGHTS
  light += surfaces(vUv) * (1.0 - light.a);
#endif
  light.rgb = raisedHighlights(light.rgb);
  vec3 color = displayedColor(light);
  for (int i = 0; i < int(flames.count); i++) {
    color += uGlareColor * glare(vUv, flames.glares[i], uMagnification) * (1.0 - color);
  }
  oColor = overPage(color, light.a, gl_FragCoord.xy);
}
