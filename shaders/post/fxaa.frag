#version 300 es
// Antialiasing of a frame of one sample a pixel: each pixel at an edge is mixed with its neighbours along the edge, whose
// direction comes from the four nearest pixels.   In and out: display colour; alpha passes through, unless it is a code.
// After Lottes 2009, "FXAA". Defines EDGE_LEAST, and BY_CODE: 1 if edges are changes of the code in alpha, 0 if of
// green, which is most of the luma.
#include "lib/precision.glsl"

uniform sampler2D uSource;

in vec2 vUv;

out vec4 oColor;

// Differences at which smoothing begins and is full.
const vec2 EDGE = vec2(EDGE_LEAST, 2.0 * EDGE_LEAST);
// Distance of the taps along the edge, pixels: each falls between two of them.
const float TAP_DISTANCE = 1.5;

float valueOf(vec4 texel) {
  return BY_CODE == 1 ? texel.a : texel.g;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(uSource, 0) - 1;
  vec4 here = texelFetch(uSource, pixel, 0);
  vec4 neighbours = vec4(
    valueOf(texelFetch(uSource, max(pixel - ivec2(1, 0), 0), 0)),
    valueOf(texelFetch(uSource, min(pixel + ivec2(1, 0), last), 0)),
    valueOf(texelFetch(uSource, max(pixel - ivec2(0, 1), 0), 0)),
    valueOf(texelFetch(uSource, min(pixel + ivec2(0, 1), last), 0))
  );
  vec4 differences = neighbours - valueOf(here);
  vec2 gradient = vec2(abs(differences.x) + abs(differences.y), abs(differences.z) + abs(differences.w));
  // Software renderers execute both sides of an `if`, but skip a loop that no pixel enters.
  for (; max(gradient.x, gradient.y) > EDGE.x; gradient = vec2(0.0)) {
    // The edge is perpendicular to the gradient.
    float side = (neighbours.y - neighbours.x) * (neighbours.w - neighbours.z) > 0.0 ? -1.0 : 1.0;
    vec2 along = normalize(vec2(gradient.y, side * gradient.x));
    vec2 offset = along * TAP_DISTANCE / vec2(last + 1);
    vec3 sum = textureLod(uSource, vUv + offset, 0.0).rgb + textureLod(uSource, vUv - offset, 0.0).rgb;
    here.rgb = mix(here.rgb, sum * 0.5, 0.8 * smoothstep(EDGE.x, EDGE.y, max(gradient.x, gradient.y)));
  }
  oColor = vec4(here.rgb, BY_CODE == 1 ? 1.0 : here.a);
}
