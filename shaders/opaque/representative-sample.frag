#version 300 es
// At which sample of the surfaces each texel of the light is worked out: the one that is and lies most as all
// around it. At any other, a joint would now and then have the light of the boards beside it, and they its.
// In:  surfaces, depth.   Out: its number, over 255.
#include "lib/precision.glsl"
#include "lib/octahedral.glsl"
#include "lib/depth.glsl"
#include "lib/gbuffer.glsl"

uniform sampler2D uGBufferSurface;
uniform vec2 uLightingSize;

out vec4 oUsual;

// What counts as much as a right angle: a difference of depth, as a share of the distance.
const float DEEP = 0.2;
// So much more like all others another one has to be than the middle one.
const float BETTER = 0.02;

// How a sample lies, and how near it is.
vec4 normalAndNearness(ivec2 at) {
  ivec2 inside = clamp(at, ivec2(0), textureSize(uGBufferSurface, 0) - 1);
  vec3 normal = normalize(octahedralDecode(texelFetch(uGBufferSurface, inside, 0).rg));
  return vec4(normal, nearnessOf(texelFetch(uDepth, inside, 0).r));
}

void main() {
  ivec2 middle = pixelOfTexel(ivec2(gl_FragCoord.xy), uLightingSize, vec2(textureSize(uGBufferSurface, 0)));
  vec4 mean = vec4(0.0);
  for (int i = 0; i < AROUND * AROUND; i++) mean += normalAndNearness(middle + aside(i)) / float(AROUND * AROUND);
  int usual = MIDDLE;
  float most = -1e9;
  for (int i = 0; i < AROUND * AROUND; i++) {
    vec4 here = normalAndNearness(middle + aside(i));
    float alike = dot(here.xyz, mean.xyz) - abs(here.w / mean.w - 1.0) / DEEP;
    if (i == MIDDLE) alike += BETTER;
    if (alike > most) usual = i;
    most = max(most, alike);
  }
  oUsual = vec4(float(usual) / 255.0, 0.0, 0.0, 1.0);
}
