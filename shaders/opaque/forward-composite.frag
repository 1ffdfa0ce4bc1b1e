#version 300 es
// Composite of the forward stage: radiance per candela times the flame's intensity; MOONLIT: and the moonlight. CANDLE:
// of a standing candle, added to the rest. CANDLES: of two to four. KEPT: in motion, by a light that moves: what the
// previous frame had is clamped to what was shaded beside it.
// In:  radiance per candela, or normals to inspect.   Out: radiance, cd/m².
#include "lib/precision.glsl"
#ifdef CANDLE
uniform vec3 uIntensity;  // cd
#ifdef CANDLES
uniform sampler2D uRadiance1;
uniform sampler2D uRadiance2;
uniform sampler2D uRadiance3;
uniform vec3 uIntensity1;
uniform vec3 uIntensity2;
uniform vec3 uIntensity3;
#endif
#else
#include "lib/flame-light.glsl"
#endif

uniform sampler2D uRadiance;
#ifndef CANDLE
uniform float uIsLight;  // 0: normals, or radiance of all flames as they burn
#endif

#if defined(MOONLIT) || defined(KEPT)
#include "lib/kept-radiance.glsl"
#endif
#ifdef MOONLIT
uniform vec3 uMoonlight;  // lx
#endif

out vec4 oRadiance;

#ifdef KEPT
// Radiance that was kept, clamped to the pixels beside its quad that were shaded: two on each side.
vec4 clampedToShaded(vec4 kept, ivec2 pixel) {
  ivec2 quad = clamp((pixel >> 1) << 1, ivec2(1), textureSize(uRadiance, 0) - 3);
  vec4 beside[8] = vec4[8](
    texelFetchOffset(uRadiance, quad, 0, ivec2(-1, 0)), texelFetchOffset(uRadiance, quad, 0, ivec2(-1, 1)),
    texelFetchOffset(uRadiance, quad, 0, ivec2(2, 0)), texelFetchOffset(uRadiance, quad, 0, ivec2(2, 1)),
    texelFetchOffset(uRadiance, quad, 0, ivec2(0, -1)), texelFetchOffset(uRadiance, quad, 0, ivec2(1, -1)),
    texelFetchOffset(uRadiance, quad, 0, ivec2(0, 2)), texelFetchOffset(uRadiance, quad, 0, ivec2(1, 2)));
  vec4 least = vec4(1e9);
  vec4 most = vec4(-1.0);
  for (int i = 0; i < 8; i++) {
    if (beside[i].a < 0.0) continue;
    least = min(least, beside[i]);
    most = max(most, beside[i]);
  }
  return most.a < 0.0 ? kept : clamp(vec4(kept.rgb, luminancePerLux(kept.a)), least, most);
}
#endif

void main() {
  vec4 perUnit = texelFetch(uRadiance, ivec2(gl_FragCoord.xy), 0);
#ifdef KEPT
  if (perUnit.a < 0.0) perUnit = clampedToShaded(perUnit, ivec2(gl_FragCoord.xy));
#endif
#ifdef CANDLE
  oRadiance = vec4(perUnit.rgb * uIntensity, 0.0);
#ifdef CANDLES
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  oRadiance.rgb += texelFetch(uRadiance1, pixel, 0).rgb * uIntensity1;
  if (uIntensity2.r > 0.0) oRadiance.rgb += texelFetch(uRadiance2, pixel, 0).rgb * uIntensity2;
  if (uIntensity3.r > 0.0) oRadiance.rgb += texelFetch(uRadiance3, pixel, 0).rgb * uIntensity3;
#endif
  // Twice this is added to 3e4: the largest half float is 65504.
  oRadiance.rgb = min(oRadiance.rgb, 1.5e4);
#else
  vec3 radiance = perUnit.rgb * mix(vec3(1.0), light.intensity, uIsLight);
#ifdef MOONLIT
  radiance += luminancePerLux(perUnit.a) * uMoonlight;
#endif
  // The largest half float is 65504; a mirrored flame can be brighter.
  oRadiance = vec4(min(radiance, 3e4), 1.0);
#endif
}
