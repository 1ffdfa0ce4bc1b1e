#version 300 es
// The image that a refinement begins with in two lights, without the flame's glare. It has one sample a pixel, and is
// antialiased.
// In:  radiance per candela.   Out: display colours, in the dimmer and in the brighter light.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/srgb.glsl"
#include "lib/refined-light.glsl"
#include "lib/tone-lut.glsl"
#include "lib/fxaa.glsl"

uniform sampler2D uRadiance;
uniform sampler2D uReference;  // of the dimmer light: refinement/reference.frag
uniform vec3 uWhiteBalance;    // of a flame of 1 cd

layout(location = 0) out vec4 oDimmer;
layout(location = 1) out vec4 oBrighter;

// Differences of tone-mapped light at which smoothing begins and is full.
const vec2 EDGE = vec2(0.08, 0.16);

// About what a display shows of exposed light: edges there are those that are visible.
vec3 toneMapped(vec3 exposed) {
  return sqrt(exposed / (1.0 + exposed));
}

vec3 inverseToneMapped(vec3 color) {
  vec3 squared = min(color * color, 0.9999);
  return squared / (1.0 - squared);
}

// Green is most of the luma.
float neighbour(ivec2 offset, vec3 gain) {
  ivec2 end = textureSize(uRadiance, 0) - 1;
  return toneMapped(texelFetch(uRadiance, clamp(ivec2(gl_FragCoord.xy) + offset, ivec2(0), end), 0).rgb * gain).g;
}

void main() {
  vec3 gain = uWhiteBalance * (frame.exposure * exp2(texelFetch(uReference, ivec2(0), 0).r));
  vec3 exposed = texelFetch(uRadiance, ivec2(gl_FragCoord.xy), 0).rgb * gain;
  vec3 here = toneMapped(exposed);
  vec4 neighbours = vec4(
    neighbour(ivec2(-1, 0), gain),
    neighbour(ivec2(1, 0), gain),
    neighbour(ivec2(0, -1), gain),
    neighbour(ivec2(0, 1), gain)
  );
  vec4 differences = neighbours - here.g;
  vec2 gradient = edgeGradient(differences);
  // Software renderers execute both sides of an `if`, but skip a loop that no pixel enters.
  for (; max(gradient.x, gradient.y) > EDGE.x; gradient = vec2(0.0)) {
    vec2 tap = tapAlongEdge(differences, gradient);
    vec2 size = vec2(textureSize(uRadiance, 0));
    vec3 sum = toneMapped(textureLod(uRadiance, (gl_FragCoord.xy + tap) / size, 0.0).rgb * gain);
    sum += toneMapped(textureLod(uRadiance, (gl_FragCoord.xy - tap) / size, 0.0).rgb * gain);
    exposed = inverseToneMapped(mix(here, 0.5 * sum, shareOfTaps(gradient, EDGE)));
  }
  exposed /= TONE_LUT_MAX;
  // The same dither for all channels, and for both.
  float dithering = dither(gl_FragCoord.xy).r;
  oDimmer = vec4(lookUpTone(exposed) + dithering, 1.0);
  oBrighter = vec4(lookUpTone(exposed * REFERENCE_RATIO) + dithering, 1.0);
}
