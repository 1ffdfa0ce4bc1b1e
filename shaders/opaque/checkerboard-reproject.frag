#version 300 es
// Checkerboard rendering, before surfaces are shaded: pixels that keep what the previous frame had.
// In:  depth of both frames, previous radiance.   Out: radiance, alpha below 0; depth 0, behind which all is hidden.
#include "lib/precision.glsl"
#include "lib/depth.glsl"
#include "lib/checkerboard.glsl"

// Least normal half float.
const float LEAST = 6.2e-5;

out vec4 oRadiance;

void main() {
  vec4 radiance;
  if (!isKept(ivec2(gl_FragCoord.xy), radiance)) discard;
  oRadiance = vec4(radiance.rgb, -max(radiance.a, LEAST));
  gl_FragDepth = 0.0;
}
