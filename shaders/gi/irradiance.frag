#version 300 es
// Irradiance atlas: the probes' octahedral maps with a border of one texel, which continues across the map's edge.
// In:  lx, maps without a border; EXTRAPOLATED: the last three of a series, and their weights.   Out: lx.
#include "lib/precision.glsl"
#include "lib/octahedral.glsl"
#include "lib/irradiance-volume.glsl"

uniform sampler2D uLast;
#if EXTRAPOLATED
uniform sampler2D uPrevious;
uniform sampler2D uBefore;
uniform sampler2D uPreviousWeight;  // gi/bounce-limit.frag
uniform sampler2D uBeforeWeight;
#endif

out vec4 oIrradiance;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec2 tile = pixel / int(IRRADIANCE_EDGE);
  vec2 uv = (vec2(pixel - tile * int(IRRADIANCE_EDGE)) + 0.5 - BORDER) / (IRRADIANCE_EDGE - 2.0 * BORDER);
  ivec2 place = ivec2(octahedralEncode(normalize(octahedralDecode(uv))) * float(IRRADIANCE_TEXELS));
  ivec2 texel = tile * IRRADIANCE_TEXELS + min(place, IRRADIANCE_TEXELS - 1);
  vec3 irradiance = texelFetch(uLast, texel, 0).rgb;
#if EXTRAPOLATED
  vec3 last = irradiance;
  irradiance += (texelFetch(uPrevious, texel, 0).rgb - last) * texelFetch(uPreviousWeight, ivec2(0), 0).rgb;
  irradiance += (texelFetch(uBefore, texel, 0).rgb - last) * texelFetch(uBeforeWeight, ivec2(0), 0).rgb;
#endif
  oIrradiance = vec4(max(irradiance, 0.0), 1.0);
}
