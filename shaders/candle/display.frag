#version 300 es
// From the candle's light to the page: exposure, adaptation, tone, sRGB, and how much it covers.
// In:  radiance, cd/m², premultiplied.   Out: display colour, premultiplied: light covers the page as
// much as it outshines it, so no channel is above alpha, and every compositor agrees on the result.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/photometry.glsl"
#include "lib/srgb.glsl"
#include "lib/chromatic-adaptation.glsl"
#include "lib/tone-curve.glsl"

uniform sampler2D uRadiance;
uniform vec4 uHalo;  // centre of the light (x, y) and half height, in heights of the picture; strength
uniform vec3 uHaloColor;

in vec2 vUv;

out vec4 oColor;

vec3 shown(vec3 radiance) {
  return encodeSrgb(tone(adapted(radiance) * frame.exposure));
}

// Light scattered in the eye falls off with the square of the angle (Vos 1984, "Disability glare").
// It ends before the picture does, so that no box is seen.
float halo(vec2 uv) {
  float aspect = frame.viewport.x / frame.viewport.y;
  vec2 away = (uv - uHalo.xy) * vec2(aspect, 1.0);
  away.y -= clamp(away.y, -uHalo.z, uHalo.z);
  vec2 margin = smoothstep(vec2(0.0), vec2(0.12), uv) * smoothstep(vec2(0.0), vec2(0.12), 1.0 - uv);
  float reach = length(away) / min(aspect, 1.0);
  return uHalo.w * exp(-reach * 7.0) / (1.0 + reach * reach * 900.0) * margin.x * margin.y;
}

void main() {
  vec4 light = texture(uRadiance, vUv);
  vec3 solid = light.a > 0.0 ? shown(light.rgb / light.a) * light.a : vec3(0.0);
  vec3 color = mix(shown(light.rgb), solid, smoothstep(0.3, 0.6, light.a));
  vec3 glare = uHaloColor * halo(vUv);
  color = color + glare * (1.0 - color);
  // One noise for all channels: the cover, the most of three noises, would be too much. It ends with the
  // light, in no step: on white that would be a ring.
  color += dither(gl_FragCoord.xy).x * min(color * 255.0, 1.0);
  float cover = max(light.a, max(max(color.r, color.g), color.b));
  oColor = min(vec4(color, cover), 1.0);
}
