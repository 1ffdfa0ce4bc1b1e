#version 300 es
// The light at each probe: what bounced once, and what its rays see of light that bounced before.
// Out: three coefficients of radiance.
#include "lib/precision.glsl"
#include "lib/octahedral.glsl"
#include "lib/photometry.glsl"
#include "lib/sh.glsl"
#include "lib/probe-rays.glsl"

uniform sampler2D uSh0;
uniform sampler2D uSh1;
uniform sampler2D uSh2;
uniform sampler2D uRayRadiance;

layout(location = 0) out vec4 oSh0;
layout(location = 1) out vec4 oSh1;
layout(location = 2) out vec4 oSh2;

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
      vec3 onMap = octahedralDecode((vec2(s, t) + 0.5) / float(RAYS));
      float solidAngle = raySolidAngle(onMap);
      total += solidAngle;
      vec3 light = texelFetch(uRayRadiance, tile * RAYS + ivec2(s, t), 0).rgb * solidAngle;
      vec3 direction = normalize(onMap);
      first += shBasis(k, direction) * light;
      second += shBasis(k + 3, direction) * light;
      third += shBasis(k + 6, direction) * light;
    }
  }
  float scale = 4.0 * PI / total;
  oSh0 = texelFetch(uSh0, texel, 0) + vec4(first * scale, 0.0);
  oSh1 = texelFetch(uSh1, texel, 0) + vec4(second * scale, 0.0);
  oSh2 = texelFetch(uSh2, texel, 0) + vec4(third * scale, 0.0);
}
