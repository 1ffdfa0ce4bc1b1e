#version 300 es
// The light at each probe: what bounced once, and what its rays see of light that bounced before.
// Out: three coefficients of radiance.
#include "lib/precision.glsl"
#include "lib/octahedral.glsl"
#include "lib/photometry.glsl"
#include "lib/sh.glsl"
#include "lib/probe-rays.glsl"

uniform sampler2D uFirst;
uniform sampler2D uSecond;
uniform sampler2D uThird;
uniform sampler2D uEcho;

layout(location = 0) out vec4 oFirst;
layout(location = 1) out vec4 oSecond;
layout(location = 2) out vec4 oThird;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  ivec2 tile = ivec2(texel.x / TILE, texel.y);
  int k = texel.x - tile.x * TILE;
  vec3 first = vec3(0.0);
  vec3 second = vec3(0.0);
  vec3 third = vec3(0.0);
  float total = 0.0;
  for (int t = 0; t < RAYS; t++) {
    for (int s = 0; s < RAYS; s++) {
      vec3 onMap = octahedronAt((vec2(s, t) + 0.5) / float(RAYS));
      float solidAngle = rayAngle(onMap);
      total += solidAngle;
      vec3 light = texelFetch(uEcho, tile * RAYS + ivec2(s, t), 0).rgb * solidAngle;
      vec3 direction = normalize(onMap);
      first += harmonic(k, direction) * light;
      second += harmonic(k + 3, direction) * light;
      third += harmonic(k + 6, direction) * light;
    }
  }
  float scale = 4.0 * PI / total;
  oFirst = texelFetch(uFirst, texel, 0) + vec4(first * scale, 0.0);
  oSecond = texelFetch(uSecond, texel, 0) + vec4(second * scale, 0.0);
  oThird = texelFetch(uThird, texel, 0) + vec4(third * scale, 0.0);
}
