#version 300 es
// A coarse picture whose edges are no staircases, nor its joints dotted lines: each pixel at an edge is mixed
// with those along it.   In and out: display colour; alpha is kept.
// After Lottes 2009, "FXAA", with the edge's direction from the four neighbours.
#include "lib/precision.glsl"

uniform sampler2D uSource;

in vec2 vUv;

out vec4 oColor;

// Differences of green, which is most of the luma, that nobody sees as an edge, and that everybody does.
const vec2 EDGE = vec2(0.06, 0.12);
// How far along the edge, pixels: in between two of them.
const float REACH = 1.5;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(uSource, 0) - 1;
  vec4 here = texelFetch(uSource, at, 0);
  vec4 around = vec4(
    texelFetch(uSource, max(at - ivec2(1, 0), 0), 0).g,
    texelFetch(uSource, min(at + ivec2(1, 0), last), 0).g,
    texelFetch(uSource, max(at - ivec2(0, 1), 0), 0).g,
    texelFetch(uSource, min(at + ivec2(0, 1), last), 0).g
  );
  vec4 apart = around - here.g;
  vec2 change = vec2(abs(apart.x) + abs(apart.y), abs(apart.z) + abs(apart.w));
  float most = max(change.x, change.y);
  if (most > EDGE.x) {
    // Across the edge it changes most; along it, a quarter turn away, least.
    float side = (around.y - around.x) * (around.w - around.z) > 0.0 ? -1.0 : 1.0;
    vec2 along = normalize(vec2(change.y, side * change.x));
    vec2 way = along * REACH / vec2(last + 1);
    vec3 beside = textureLod(uSource, vUv + way, 0.0).rgb + textureLod(uSource, vUv - way, 0.0).rgb;
    here.rgb = mix(here.rgb, beside * 0.5, 0.8 * smoothstep(EDGE.x, EDGE.y, most));
  }
  oColor = here;
}
