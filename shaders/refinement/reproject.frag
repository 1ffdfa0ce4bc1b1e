#version 300 es
// First frames in motion: the refined image, reprojected over the coarser one.
// In:  depth and albedo of the frame; refined display colours in two lights, and their depth.   Out: display colour.
#include "lib/precision.glsl"
#include "lib/depth.glsl"
#include "lib/gbuffer.glsl"
#include "lib/reproject.glsl"

uniform sampler2D uGBufferAlbedo;  // alpha: whether the surface is held
uniform sampler2D uDimmer;
uniform sampler2D uBrighter;
uniform sampler2D uRefinedDepth;
uniform float uWeight;
uniform vec4 uMedia;  // the part of the frame that the media are drawn in anew: left, bottom, right, top, uv

in vec2 vUv;
flat in float vShare;

out vec4 oColor;

// Differences of depth within a surface, at most: relative, and m.
const vec2 TOLERANCE = vec2(0.03, 0.01);

// Width over which the image fades towards that part, uv: without the flame's glare it would end at an edge.
const float FADE = 0.03;

void main() {
  vec4 current = vec4(vUv, texture(uDepth, vUv).r, 1.0);
  float isHeld = isHeldSurface(texture(uGBufferAlbedo, vUv).a);
  vec4 projected = mix(uPreviousFromCurrentRoom * current, uPreviousFromCurrentHeld * current, isHeld);
  vec3 previous = projected.xyz / projected.w;
  vec2 isInside = step(abs(previous.xy - 0.5), vec2(0.5));
  float expected = linearDepth(previous.z);
  float found = linearDepth(texture(uRefinedDepth, previous.xy).r);
  float isSame = step(abs(found - expected), TOLERANCE.x * expected + TOLERANCE.y);
  vec2 beyond = max(max(uMedia.xy - vUv, vUv - uMedia.zw), 0.0);
  float fade = smoothstep(0.0, FADE, length(beyond));
  float weight = uWeight * fade * isInside.x * isInside.y * isSame;
  vec3 color = mix(texture(uDimmer, previous.xy), texture(uBrighter, previous.xy), vShare).rgb;
  oColor = vec4(color * weight, weight);
}
