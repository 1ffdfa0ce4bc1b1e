// Display of a lone candle, with alpha for the page's background.
#include "lib/frame.glsl"
#include "lib/srgb.glsl"
#include "lib/chromatic-adaptation.glsl"
#include "lib/tone-curve.glsl"

vec3 displayColor(vec3 radiance) {
  return encodeSrgb(tone(adaptRadiance(radiance) * frame.exposure));
}

// Glare in the eye, which falls off with the square of the angle (Vos 1984, "Disability glare"), and to 0 at the
// canvas's edges. `source`: centre of the light and its half height, uv; strength. `magnification`: of angles.
float glare(vec2 uv, vec4 source, float magnification) {
  float aspect = frame.viewport.x / frame.viewport.y;
  vec2 offset = (uv - source.xy) * vec2(aspect, 1.0);
  offset.y -= clamp(offset.y, -source.z, source.z);
  vec2 margin = smoothstep(vec2(0.0), vec2(0.12), uv) * smoothstep(vec2(0.0), vec2(0.12), 1.0 - uv);
  float angle = length(offset) / min(aspect, 1.0) * magnification;
  return source.w * exp(-angle * 7.0) / (1.0 + angle * angle * 900.0) * margin.x * margin.y;
}

// Light of a flame, as a multiple of white; no surface has as much.
const vec2 FLAME_LIGHT = vec2(16.0, 64.0);

// Display colour of a texel, premultiplied, before glare. A flame covers all of a texel, surfaces and smoke may not.
vec3 displayedColor(vec4 light) {
  vec3 straight = light.rgb / max(light.a, 1e-4);
  float flame = smoothstep(FLAME_LIGHT.x, FLAME_LIGHT.y, straight.r * frame.exposure);
  return mix(displayColor(straight) * light.a, displayColor(light.rgb), flame);
}

// Alpha is at least the largest channel, so that every compositor gives the same result.
vec4 overPage(vec3 color, float alpha, vec2 pixel) {
  // The same dither for all channels: alpha, the largest of three, would be biased. It fades out with the light: a
  // step would show as a ring on white.
  color += dither(pixel).x * min(color * 255.0, 1.0);
  return min(vec4(color, max(alpha, max(max(color.r, color.g), color.b))), 1.0);
}
