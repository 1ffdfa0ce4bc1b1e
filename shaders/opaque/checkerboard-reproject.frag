#version 300 es
// Checkerboard rendering, before surfaces are shaded: pixels that keep what the previous frame had. STILL: no light moves,
// and what is kept is not clamped.
// In:  depth of both frames, previous radiance.   Out: radiance, alpha below 0; depth 0, behind which all is hidden.
#include "lib/precision.glsl"
#include "lib/depth.glsl"
#include "lib/photometry.glsl"
#include "lib/kept-radiance.glsl"

uniform sampler2D uPreviousRadiance;  // alpha below 0: reprojected
uniform sampler2D uPreviousDepth;
uniform mat4 uPreviousFromCurrent;    // of uv and depth, 0 to 1
uniform vec4 uHeldBounds;             // of what moves with the camera, pixels: from, to
uniform float uHeldDistance;          // of its farthest point along the view axis, m
uniform float uIsFirst;               // 1 or 0: whether all of the previous frame was shaded
uniform float uTurns;                 // frames after which a quad is shaded again: 2 or 4
#if STILL
uniform vec2 uIntensity;              // of the flame, cd, and the moon, lx
#endif

// Depths on one surface differ by less, as a share of the distance. Joints between logs are as shallow; STILL, their
// contrast tells.
const float SAME_SURFACE = STILL == 1 ? 0.005 : 0.001;
// A larger ratio of luminances, interpolated, would be seen.
const float MOST_CONTRAST = 2.0;

bool isHeldSurface(ivec2 pixel, float depth) {
  vec2 center = vec2(pixel) + 0.5;
  bool isWithin = all(greaterThan(center, uHeldBounds.xy)) && all(lessThan(center, uHeldBounds.zw));
  return isWithin && linearDepth(depth) < uHeldDistance;
}

// Whether depth bends within two pixels: what multisampling mixes is shaded in each frame.
bool isBesideEdge(highp sampler2D depths, ivec2 pixel, ivec2 end) {
  float depth = texelFetch(depths, pixel, 0).r;
  ivec2 inside = clamp(pixel, ivec2(2), end - 2);
  vec2 beside = vec2(
    texelFetchOffset(depths, inside, 0, ivec2(2, 1)).r + texelFetchOffset(depths, inside, 0, ivec2(-2, -1)).r,
    texelFetchOffset(depths, inside, 0, ivec2(-1, 2)).r + texelFetchOffset(depths, inside, 0, ivec2(1, -2)).r
  );
  vec2 bend = abs(0.5 * beside - depth);
  return max(bend.x, bend.y) > SAME_SURFACE * inverseDepth(depth);
}

// Frames since a pixel's quad was shaded, 0 if it is its turn. `previous`: of the pixel, in the previous frame.
int quadAge(ivec2 pixel, vec2 previous, ivec2 end) {
  int turns = int(uTurns);
  ivec2 quad = pixel >> 1;
  // A square of two by two quads, across its diagonals.
  if (uIsFirst > 0.5) return (((quad.x ^ quad.y) & 1) + (quad.y & 1) * 2) % turns;
  ivec2 corner = clamp(ivec2(previous) - (pixel & 1), ivec2(0), end);
  return (ageOf(texelFetch(uPreviousRadiance, corner, 0).a) + 1) % turns;
}

// Whether a pixel keeps what the previous frame had. `radiance`: that, reprojected. `age`: frames since it was shaded.
bool isKept(ivec2 pixel, out vec4 radiance, out int age) {
  radiance = vec4(0.0);
  ivec2 size = textureSize(uDepth, 0);
  float depth = texelFetch(uDepth, pixel, 0).r;
  vec4 place = uPreviousFromCurrent * vec4((vec2(pixel) + 0.5) / vec2(size), depth, 1.0);
  vec3 previous = vec3(place.xy * vec2(size), place.z) / place.w;
  age = quadAge(pixel, previous.xy, size - 1);
  if (age == 0 || isHeldSurface(pixel, depth)) return false;
  if (isBesideEdge(uDepth, pixel, size - 1)) return false;
  vec2 corner = previous.xy - 0.5;
  if (any(lessThan(corner, vec2(0.0))) || any(greaterThanEqual(corner, vec2(size - 1)))) return false;
  ivec2 base = ivec2(corner);
  vec2 part = corner - vec2(base);
  vec4 weights = vec4(1.0 - part.x, part.x, 1.0 - part.x, part.x) * vec4(1.0 - part.yy, part.yy);
  vec4 kept[4] = vec4[4](
    texelFetch(uPreviousRadiance, base, 0), texelFetchOffset(uPreviousRadiance, base, 0, ivec2(1, 0)),
    texelFetchOffset(uPreviousRadiance, base, 0, ivec2(0, 1)), texelFetchOffset(uPreviousRadiance, base, 0, ivec2(1, 1)));
  for (int i = 0; i < 4; i++) {
    kept[i].a = luminancePerLux(kept[i].a);
    radiance += weights[i] * kept[i];
  }
#if STILL
  vec4 luminances;
  for (int i = 0; i < 4; i++) luminances[i] = dot(vec2(luma(kept[i].rgb), kept[i].a), uIntensity);
  vec2 most = max(luminances.xy, luminances.zw);
  vec2 least = min(luminances.xy, luminances.zw);
  if (max(most.x, most.y) > MOST_CONTRAST * min(least.x, least.y)) return false;
  if (isBesideEdge(uPreviousDepth, ivec2(previous.xy), size - 1)) return false;
#endif
  float before = dot(weights, vec4(
    texelFetch(uPreviousDepth, base, 0).r, texelFetchOffset(uPreviousDepth, base, 0, ivec2(1, 0)).r,
    texelFetchOffset(uPreviousDepth, base, 0, ivec2(0, 1)).r, texelFetchOffset(uPreviousDepth, base, 0, ivec2(1, 1)).r));
  // Linear across a plane: at an edge, and where something was uncovered, it differs.
  return abs(inverseDepth(before) / inverseDepth(previous.z) - 1.0) < SAME_SURFACE;
}

out vec4 oRadiance;

void main() {
  vec4 radiance;
  int age;
  if (!isKept(ivec2(gl_FragCoord.xy), radiance, age)) discard;
  oRadiance = keptRadiance(radiance, age);
  gl_FragDepth = 0.0;
}
