#version 300 es
// Checkerboard rendering, before surfaces are shaded: pixels that keep what the previous frame had.
// In:  depth of both frames, previous radiance.   Out: radiance, alpha below 0; depth 0, behind which all is hidden.
#include "lib/precision.glsl"
#include "lib/depth.glsl"
#include "lib/photometry.glsl"
#include "lib/kept-radiance.glsl"
#include "lib/checkerboard.glsl"

out vec4 oRadiance;

void main() {
  vec4 radiance;
  int age;
  if (!isKept(ivec2(gl_FragCoord.xy), radiance, age)) discard;
  oRadiance = keptRadiance(radiance, age);
  gl_FragDepth = 0.0;
}
