#version 300 es
// Sums the radiance along each probe's rays and adds it to the probe's radiance so far.
// In and out: spherical harmonics of radiance, cd/m².
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
  ivec2 tile = ivec2(texel.x / SH_TEXELS, texel.y);
  int k = texel.x - tile.x * SH_TEXELS;
  ShTexel sum = ShTexel(vec3(0.0), vec3(0.0), vec3(0.0));
  float total = 0.0;
  for (int t = 0; t < RAYS; t++) {
    for (int s = 0; s < RAYS; s++) {
      vec3 onOctahedron = octahedralDecode((vec2(s, t) + 0.5) / float(RAYS));
      float solidAngle = raySolidAngle(onOctahedron);
      total += solidAngle;
      vec3 radiance = texelFetch(uRayRadiance, tile * RAYS + ivec2(s, t), 0).rgb;
      addRadiance(sum, k, normalize(onOctahedron), radiance * solidAngle);
    }
  }
  float scale = 4.0 * PI / total;
  oSh0 = texelFetch(uSh0, texel, 0) + vec4(sum.first * scale, 0.0);
  oSh1 = texelFetch(uSh1, texel, 0) + vec4(sum.second * scale, 0.0);
  oSh2 = texelFetch(uSh2, texel, 0) + vec4(sum.third * scale, 0.0);
}
