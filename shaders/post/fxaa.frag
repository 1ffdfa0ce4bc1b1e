#version 300 es
// Antialiasing of a frame of one sample a pixel.   In: display colour, and a code in alpha.   Out: display colour.
// Edges are changes of the code by EDGE_LEAST or more.
#include "lib/precision.glsl"
#include "lib/fxaa.glsl"

uniform sampler2D uSource;  // nearest texel
uniform sampler2D uSmooth;  // the same, bilinear

in vec2 vUv;

out vec4 oColor;

// Differences at which smoothing begins and is full.
const vec2 EDGE = vec2(EDGE_LEAST, 2.0 * EDGE_LEAST);

void main() {
  vec2 pixel = 1.0 / vec2(textureSize(uSource, 0));
  vec4 here = texture(uSource, vUv);
  vec4 neighbours = vec4(
    texture(uSource, vUv - vec2(pixel.x, 0.0)).a,
    texture(uSource, vUv + vec2(pixel.x, 0.0)).a,
    texture(uSource, vUv - vec2(0.0, pixel.y)).a,
    texture(uSource, vUv + vec2(0.0, pixel.y)).a
  );
  vec4 differences = neighbours - here.a;
  vec2 gradient = edgeGradient(differences);
  // Software renderers execute both sides of an `if`, but skip a loop that no pixel enters.
  for (; max(gradient.x, gradient.y) > EDGE.x; gradient = vec2(0.0)) {
    vec2 tap = tapAlongEdge(differences, gradient) * pixel;
    vec3 sum = textureLod(uSmooth, vUv + tap, 0.0).rgb + textureLod(uSmooth, vUv - tap, 0.0).rgb;
    here.rgb = mix(here.rgb, sum * 0.5, shareOfTaps(gradient, EDGE));
  }
  oColor = vec4(here.rgb, 1.0);
}
