#version 300 es
// The image that a refinement begins with in two lights, without the flame's glare.
// In:  radiance per candela.   Out: display colours, in the dimmer and in the brighter light.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/srgb.glsl"
#include "lib/refined-light.glsl"
#include "lib/tone-lut.glsl"

uniform sampler2D uRadiance;
uniform sampler2D uReference;  // of the dimmer light: refinement/reference.frag
uniform vec3 uWhiteBalance;    // of a flame of 1 cd

layout(location = 0) out vec4 oDimmer;
layout(location = 1) out vec4 oBrighter;

void main() {
  vec3 gain = uWhiteBalance * (frame.exposure * exp2(texelFetch(uReference, ivec2(0), 0).r) / TONE_LUT_MAX);
  vec3 exposed = texelFetch(uRadiance, ivec2(gl_FragCoord.xy), 0).rgb * gain;
  // The same dither for all channels, and for both.
  float dithering = dither(gl_FragCoord.xy).r;
  oDimmer = vec4(lookUpTonePreservingHue(exposed) + dithering, 1.0);
  oBrighter = vec4(lookUpTonePreservingHue(exposed * REFERENCE_RATIO) + dithering, 1.0);
}
