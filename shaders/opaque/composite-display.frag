#version 300 es
// The room's light as it is on the screen, straight away: the display's law is looked up in a table.
// In:  paint, light, bloom.   Out: display colour; COARSE, in its alpha, what is carried.
#include "lib/precision.glsl"
#include "lib/srgb.glsl"
#include "lib/flame-light.glsl"
#include "lib/gbuffer.glsl"
#if COARSE
#include "lib/depth.glsl"
#if HISTORY
#include "lib/reproject.glsl"
#endif
#include "lib/upsample-bilateral.glsl"
#else
#include "lib/upsample-guided.glsl"
#endif
#include "lib/composite.glsl"
#include "lib/tone-lut.glsl"
#include "lib/tone-lut-lookup.glsl"

uniform sampler2D uBloom;
uniform vec2 uGlareOffset;   // from a place in the picture to the one in that of the bloom
uniform vec3 uWhiteBalance;     // makes the candle's light white
uniform float uGlareShare;  // share of the light that eye and lens scatter

in vec2 vUv;
flat in float vExposure;

out vec4 oColor;

void main() {
  vec4 painted = texelFetch(uGBufferAlbedo, ivec2(gl_FragCoord.xy), 0);
  vec3 radiance = compositeRadiance(painted, vUv) + texture(uBloom, vUv + uGlareOffset).rgb * uGlareShare;
  vec3 exposed = max(radiance, 0.0) * uWhiteBalance * (vExposure / TONE_LUT_MAX);
  // What is brighter than the table keeps its hue.
  exposed /= max(max(exposed.r, exposed.g), max(exposed.b, 1.0));
  // The same noise for all channels.
  oColor = vec4(toneLutColor(exposed) + dither(gl_FragCoord.xy).r, COARSE == 1 ? painted.a : 1.0);
}
