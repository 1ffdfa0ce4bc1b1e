#version 300 es
// First frames in motion: the refined image, reprojected over the coarser one.
// In:  G-buffer of the frame, or of the one before; refined display colours in two lights, and their depth.
// Out: display colour.
#include "lib/precision.glsl"
#include "lib/depth.glsl"
#include "lib/gbuffer.glsl"
#include "lib/reproject.glsl"
#include "lib/upsample-bilateral.glsl"

uniform mat4 uRefinedFromCurrentRoom;
uniform mat4 uRefinedFromCurrentHeld;  // of what moves with the camera
uniform sampler2D uDimmer;
uniform sampler2D uBrighter;
uniform sampler2D uRefinedDepth;
uniform float uWeight;
uniform vec4 uMedia;  // the part of the frame that the media are drawn in anew: left, bottom, right, top, uv

in vec2 vUv;
flat in float vShare;
in vec4 vRoom;
in vec4 vHeld;

out vec4 oColor;

// Differences of depth within a surface, at most: relative, and m.
const vec2 TOLERANCE = vec2(0.03, 0.01);

// Width over which the image fades towards that part, uv: without the flame's glare it would end at an edge.
const float FADE = 0.03;

// Place on the refined image of what the pixel would show at the depth that the frame has at `uv`.
vec3 previousAt(vec2 uv) {
  float depth = frameDepth(uv);
  bool isHeld = isHeldSurface(textureLod(uGBufferAlbedo, uv, 0.0).a) > 0.5;
  vec4 previous = isHeld ? vHeld + depth * uRefinedFromCurrentHeld[2] : vRoom + depth * uRefinedFromCurrentRoom[2];
  return previous.xyz / previous.w;
}

float refinedDepth(vec2 uv) {
  return linearDepth(textureLod(uRefinedDepth, uv, 0.0).r);
}

// 1 where the refined image shows that surface, else 0: beside a closer one its colour is mixed with that one's.
float showsSame(vec3 previous) {
  vec2 isInside = step(abs(previous.xy - 0.5), vec2(0.5));
  float expected = linearDepth(previous.z);
  float tolerance = TOLERANCE.x * expected + TOLERANCE.y;
  vec2 texel = 1.0 / vec2(textureSize(uRefinedDepth, 0));
  float closest = min(refinedDepth(previous.xy - texel), refinedDepth(previous.xy + texel));
  float isSame = step(abs(refinedDepth(previous.xy) - expected), tolerance) * step(expected - closest, tolerance);
  return isSame * isInside.x * isInside.y;
}

void main() {
  vec3 previous = previousAt(vUv);
  float isSame = showsSame(previous);
  // Beside an edge the frame's coarser depth may be that of the other surface: of four neighbours one has the right one.
  vec2 texel = 1.0 / vec2(textureSize(uDepth, 0));
  for (int i = 0; i < 4 && isSame < 0.5; i++) {
    previous = previousAt(vUv + (vec2(i & 1, i >> 1) * 2.0 - 1.0) * texel);
    isSame = showsSame(previous);
  }
  vec2 beyond = max(max(uMedia.xy - vUv, vUv - uMedia.zw), 0.0);
  float weight = uWeight * smoothstep(0.0, FADE, length(beyond)) * isSame;
  vec3 color = mix(textureLod(uDimmer, previous.xy, 0.0), textureLod(uBrighter, previous.xy, 0.0), vShare).rgb;
  oColor = vec4(color * weight, weight);
}
