#version 300 es
// Checkerboard rendering, after surfaces are shaded: where shadows move, what was kept is clamped to the pixels beside its
// quad that were shaded.
// In:  radiance, alpha below 0: reprojected.   Out: the same, clamped.
#include "lib/precision.glsl"
#include "lib/kept-radiance.glsl"

uniform sampler2D uRadiance;
uniform float uClamps;  // 1 or 0

out vec4 oRadiance;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 radiance = texelFetch(uRadiance, pixel, 0);
  oRadiance = radiance;
  if (radiance.a >= 0.0 || uClamps < 0.5) return;
  ivec2 end = textureSize(uRadiance, 0) - 1;
  ivec2 quad = (pixel >> 1) << 1;
  vec4 least = vec4(1e9);
  vec4 most = vec4(-1.0);
  for (int i = 0; i < 8; i++) {
    // Two pixels on each of the four sides.
    int along = i & 1;
    int across = (i & 2) == 0 ? -1 : 2;
    ivec2 beside = clamp(quad + (i < 4 ? ivec2(across, along) : ivec2(along, across)), ivec2(0), end);
    vec4 shaded = texelFetch(uRadiance, beside, 0);
    if (shaded.a < 0.0) continue;
    least = min(least, shaded);
    most = max(most, shaded);
  }
  if (most.a < 0.0) return;
  oRadiance = keptRadiance(clamp(vec4(radiance.rgb, luminancePerLux(radiance.a)), least, most), ageOf(radiance.a));
}
