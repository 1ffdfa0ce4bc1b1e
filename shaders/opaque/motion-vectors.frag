#version 300 es
// Motion vectors of a reduced frame: from each texel to its surface in the history buffer.
// In:  depth, albedo's alpha telling what is held.
// Out: motion, uv; whether there is an outline of what is held, unless REPROJECTED: of a frame that has the G-buffer of
//      the one before; whether the texel's own surface is held.
#include "lib/precision.glsl"
#include "lib/depth.glsl"
#include "lib/gbuffer.glsl"
#include "lib/reproject.glsl"

uniform sampler2D uGBufferAlbedo;  // nearest texel, unless REPROJECTED

in vec2 vUv;

out vec4 oMotion;

#if REPROJECTED
vec4 motionOf(vec2 uv, vec2 texel) {
  float depth = texture(uDepth, uv).r;
  // Outlines of what is held, too, which the history has antialiased.
  float stored = max(texture(uGBufferAlbedo, uv + 0.5 * texel).a, texture(uGBufferAlbedo, uv - 0.5 * texel).a);
  float isHeld = step(0.1 * HELD, stored);
  vec2 previous = previousUv(vec4(uv, depth, 1.0), isHeld);
  // A disocclusion has no colour in the history: it keeps the previous colour of the pixel.
  float isKept = 1.0 - isDisoccluded(isHeld, texture(uGBufferAlbedo, previous).a);
  return vec4((previous - uv) * isKept, 0.0, isHeldSurface(texture(uGBufferAlbedo, uv).a));
}
#else
// Depth bends by more at an edge, as a share of the distance.
const vec2 EDGE = vec2(0.02, 0.04);

// uv and depth.
vec3 surfaceAt(vec2 uv) {
  return vec3(uv, texture(uDepth, uv).r);
}

vec3 closer(vec3 a, vec3 b) {
  return a.z < b.z ? a : b;
}

// Of the closest surface beside the texel, so that outlines move with what they enclose.
vec4 motionOf(vec2 uv, vec2 texel) {
  vec3 center = surfaceAt(uv);
  vec3 left = surfaceAt(uv - vec2(texel.x, 0.0));
  vec3 right = surfaceAt(uv + vec2(texel.x, 0.0));
  vec3 below = surfaceAt(uv - vec2(0.0, texel.y));
  vec3 above = surfaceAt(uv + vec2(0.0, texel.y));
  vec3 closest = closer(closer(closer(left, right), closer(below, above)), center);
  vec2 bend = abs(vec2(left.z + right.z, below.z + above.z) - 2.0 * center.z) / inverseDepth(closest.z);
  float edge = smoothstep(EDGE.x, EDGE.y, max(bend.x, bend.y));
  float isHeld = isHeldSurface(texture(uGBufferAlbedo, closest.xy).a);
  vec2 motion = previousUv(vec4(uv, closest.z, 1.0), isHeld) - uv;
  return vec4(motion, edge * isHeld, isHeldSurface(texture(uGBufferAlbedo, uv).a));
}
#endif

void main() {
  oMotion = motionOf(vUv, 1.0 / vec2(textureSize(uDepth, 0)));
}
