#version 300 es
// Composite of the refined picture and display transform in one, by the tone LUT.
// In:  radiance per candela, bloom.   Out: display colour.
#include "lib/precision.glsl"
#include "lib/srgb.glsl"
#include "lib/flame-light.glsl"
#include "lib/tone-lut.glsl"
#include "lib/tone-lut-lookup.glsl"

uniform sampler2D uRadiance;
uniform sampler2D uBloom;
uniform vec2 uGlareOffset;   // from uv of the frame to uv of the bloom
uniform vec3 uWhiteBalance;  // makes candlelight white
uniform float uGlareShare;   // share of the light that lens and eye scatter

in vec2 vUv;
flat in float vExposure;

out vec4 oColor;

void main() {
  vec3 radiance = texelFetch(uRadiance, ivec2(gl_FragCoord.xy), 0).rgb * light.intensity;
  radiance += texture(uBloom, vUv + uGlareOffset).rgb * uGlareShare;
  vec3 exposed = radiance * uWhiteBalance * (vExposure / TONE_LUT_MAX);
  // What exceeds the table keeps its hue.
  exposed /= max(max(exposed.r, exposed.g), max(exposed.b, 1.0));
  // The same dither for all channels.
  oColor = vec4(lookUpTone(exposed) + dither(gl_FragCoord.xy).r, 1.0);
}
