#version 300 es
// Antialiasing of a frame of one sample a pixel.   In and out: display colour; alpha passes through, unless it is a code.
// Defines EDGE_LEAST, and BY_CODE: 1 if edges are changes of the code in alpha, 0 if of green, which is most of the luma.
#include "lib/precision.glsl"
#include "lib/fxaa.glsl"

uniform sampler2D uSource;  // nearest texel
uniform sampler2D uSmooth;  // the same, bilinear

in vec2 vUv;

out vec4 oColor;

// Differences at which smoothing begins and is full.
const vec2 EDGE = vec2(EDGE_LEAST, 2.0 * EDGE_LEAST);

float valueOf(vec4 texel) {
  return BY_CODE == 1 ? texel.a : texel.g;
}

void main() {
  vec2 pixel = 1.0 / vec2(textureSize(uSource, 0));
  vec4 here = texture(uSource, vUv);
  vec4 neighbours = vec4(
    valueOf(texture(uSource, vUv - vec2(pixel.x, 0.0))),
    valueOf(texture(uSource, vUv + vec2(pixel.x, 0.0))),
    valueOf(texture(uSource, vUv - vec2(0.0, pixel.y))),
    valueOf(texture(uSource, vUv + vec2(0.0, pixel.y)))
  );
  vec4 differences = neighbours - valueOf(here);
  vec2 gradient = edgeGradient(differences);
  // Software renderers execute both sides of an `if`, but skip a loop that no pixel enters.
  for (; max(gradient.x, gradient.y) > EDGE.x; gradient = vec2(0.0)) {
    vec2 tap = tapAlongEdge(differences, gradient) * pixel;
    vec3 sum = textureLod(uSmooth, vUv + tap, 0.0).rgb + textureLod(uSmooth, vUv - tap, 0.0).rgb;
    here.rgb = mix(here.rgb, sum * 0.5, shareOfTaps(gradient, EDGE));
  }
  oColor = vec4(here.rgb, BY_CODE == 1 ? 1.0 : here.a);
}
