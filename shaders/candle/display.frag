#version 300 es
// Display transform of the lone candle, with alpha for the page's background.
// In:  radiance, cd/m², premultiplied.   Out: display colour, premultiplied. Alpha is at least the largest channel,
// so that every compositor gives the same result.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/photometry.glsl"
#include "lib/srgb.glsl"
#include "lib/chromatic-adaptation.glsl"
#include "lib/tone-curve.glsl"

uniform sampler2D uRadiance;
uniform vec4 uGlare;  // centre of the light and its half height, uv; strength
uniform vec3 uGlareColor;

in vec2 vUv;

out vec4 oColor;

vec3 displayColor(vec3 radiance) {
  return encodeSrgb(tone(adaptRadiance(radiance) * frame.exposure));
}

// Glare in the eye, which falls off with the square of the angle (Vos 1984, "Disability glare"), and to 0 at the
// canvas's edges.
float glare(vec2 uv) {
  float aspect = frame.viewport.x / frame.viewport.y;
  vec2 offset = (uv - uGlare.xy) * vec2(aspect, 1.0);
  offset.y -= clamp(offset.y, -uGlare.z, uGlare.z);
  vec2 margin = smoothstep(vec2(0.0), vec2(0.12), uv) * smoothstep(vec2(0.0), vec2(0.12), 1.0 - uv);
  float angle = length(offset) / min(aspect, 1.0);
  return uGlare.w * exp(-angle * 7.0) / (1.0 + angle * angle * 900.0) * margin.x * margin.y;
}

void main() {
  vec4 light = texture(uRadiance, vUv);
  vec3 solid = light.a > 0.0 ? displayColor(light.rgb / light.a) * light.a : vec3(0.0);
  vec3 color = mix(displayColor(light.rgb), solid, smoothstep(0.3, 0.6, light.a));
  vec3 scattered = uGlareColor * glare(vUv);
  color = color + scattered * (1.0 - color);
  // The same dither for all channels: alpha, the largest of three, would be biased. It fades out with the light: a
  // step would show as a ring on white.
  color += dither(gl_FragCoord.xy).x * min(color * 255.0, 1.0);
  float alpha = max(light.a, max(max(color.r, color.g), color.b));
  oColor = min(vec4(color, alpha), 1.0);
}
