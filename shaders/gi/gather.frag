#version 300 es
// Irradiance at each probe, by the radiance that it receives from SURFELS, or along its rays and before.
// Out: lx, an octahedral map of IRRADIANCE_TEXELS along an edge for each probe, from one end of the edge to the other.
#include "lib/precision.glsl"
#include "lib/octahedral.glsl"
#include "lib/probe-rays.glsl"

uniform sampler2D uRadiance;  // times solid angle, cd/m² sr: ROWS times COLUMNS for each probe
#if SURFELS
uniform sampler2D uDirection;
#else
uniform sampler2D uIrradianceBefore;  // lx
#endif

out vec4 oIrradiance;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  ivec2 tile = texel / IRRADIANCE_TEXELS;
  ivec2 place = texel - tile * IRRADIANCE_TEXELS;
  vec3 normal = normalize(octahedralDecode(vec2(place) / float(IRRADIANCE_TEXELS - 1)));
#if !SURFELS
  normal = turnedBack(normal, turnOf(tile));
#endif
  vec3 sum = vec3(0.0);
  ivec2 corner = tile * ivec2(COLUMNS, ROWS);
#if SURFELS
  for (int row = 0; row < ROWS; row++) {
    for (int column = 0; column < COLUMNS; column++) {
      ivec2 sampleAt = corner + ivec2(column, row);
      sum += texelFetch(uRadiance, sampleAt, 0).rgb * max(dot(normal, texelFetch(uDirection, sampleAt, 0).xyz), 0.0);
    }
  }
#else
  // Four directions at once, which the map's symmetry mirrors in x and z.
  ivec2 last = ivec2(COLUMNS, ROWS) - 1;
  for (int row = 0; row < ROWS / 2; row++) {
    for (int column = 0; column < COLUMNS / 2; column++) {
      ivec2 low = ivec2(column, row);
      ivec2 high = last - low;
      vec3 parts = normal * normalize(octahedralDecode((vec2(high) + 0.5) / vec2(COLUMNS, ROWS)));
      sum += texelFetch(uRadiance, corner + high, 0).rgb * max(parts.y + parts.x + parts.z, 0.0);
      sum += texelFetch(uRadiance, corner + ivec2(low.x, high.y), 0).rgb * max(parts.y - parts.x + parts.z, 0.0);
      sum += texelFetch(uRadiance, corner + ivec2(high.x, low.y), 0).rgb * max(parts.y + parts.x - parts.z, 0.0);
      sum += texelFetch(uRadiance, corner + low, 0).rgb * max(parts.y - parts.x - parts.z, 0.0);
    }
  }
  sum += texelFetch(uIrradianceBefore, texel, 0).rgb;
#endif
  oIrradiance = vec4(sum, 1.0);
}
