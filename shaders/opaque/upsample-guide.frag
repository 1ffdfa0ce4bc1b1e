#version 300 es
// Upsample guide: joint bilateral upsampling, decided once for an image at rest. Each pixel stores where among the
// four lighting texels around it to read: interpolated where all lie on its own surface, else at the nearest that
// does. Where a pixel's samples lie on several surfaces, their guides are averaged, as their albedos are; panes' guides
// only where all samples are panes.
// In:  G-buffer, SAMPLES x SAMPLES for each pixel.   Out: gamma-2 albedo; guide in alpha. Depth.
// After Kopf, Cohen, Lischinski and Uyttendaele 2007, "Joint Bilateral Upsampling".
#include "lib/precision.glsl"
#include "lib/depth.glsl"
#include "lib/gbuffer.glsl"
#include "lib/representative-sample.glsl"

uniform sampler2D uAlbedo;
uniform sampler2D uGBufferSurface;
uniform vec2 uLightingSize;

out vec4 oAlbedo;

// Differences within a surface, at most: of depth, relative, and of the normal, on the octahedral square.
const float DEPTH_TOLERANCE = 0.02;
const float NORMAL_TOLERANCE = 0.06;
// Difference between a pane and anything else: it is as near as its frame, and as upright.
const float PANE_DIFFERENCE = 4.0;
// Weight of other surfaces' texels up to which the lighting is interpolated all the same.
const float NEGLIGIBLE = 0.04;
const float PANE_WEIGHT = 1e-3;

float inverseDistance(ivec2 texel) {
  return 1.0 / linearDepth(texelFetch(uDepth, texel, 0).r);
}

// The smaller of two differences: the other one may cross an edge.
float slope(float before, float center, float after) {
  return abs(after - center) < abs(center - before) ? after - center : center - before;
}

// Where a sample reads among the lighting texels from `corner` on, 0 to 1; `isInterpolated` is 1 or 0.
vec2 guideOf(ivec2 texel, vec4 surface, vec2 corner, vec2 size, out float isInterpolated) {
  ivec2 last = ivec2(size) - 1;
  // Inverse depth is linear across a plane.
  float center = inverseDistance(texel);
  vec2 slopes = vec2(
    slope(inverseDistance(max(texel - ivec2(1, 0), 0)), center, inverseDistance(min(texel + ivec2(1, 0), last))),
    slope(inverseDistance(max(texel - ivec2(0, 1), 0)), center, inverseDistance(min(texel + ivec2(0, 1), last)))
  );
  vec2 fraction = clamp((vec2(texel) + 0.5) / size * uLightingSize - 0.5 - corner, 0.0, 1.0);
  float otherWeight = 0.0;
  float bestWeight = -1.0;
  float leastDifference = 1e9;
  vec2 nearest = vec2(0.0);
  for (int i = 0; i < 4; i++) {
    ivec2 offset = ivec2(i & 1, i >> 1);
    ivec2 lightingTexel = clamp(ivec2(corner) + offset, ivec2(0), ivec2(uLightingSize) - 1);
    ivec2 neighbour = representativeSample(lightingTexel, uLightingSize, ivec2(size));
    float expected = center + dot(vec2(neighbour - texel), slopes);
    float depthDifference = abs(inverseDistance(neighbour) - expected) / center;
    vec4 other = texelFetch(uGBufferSurface, neighbour, 0);
    vec2 normalDifference = abs(other.rg - surface.rg);
    float difference = depthDifference / DEPTH_TOLERANCE
      + (normalDifference.x + normalDifference.y) / NORMAL_TOLERANCE;
    if (isGlass(other.a) != isGlass(surface.a)) difference += PANE_DIFFERENCE;
    vec2 weights = mix(1.0 - fraction, fraction, vec2(offset));
    float weight = weights.x * weights.y;
    bool isOther = difference > 2.0;
    if (isOther) otherWeight += weight;
    // Among texels of its own surface the nearest; among others the most similar.
    bool isBetter = isOther ? bestWeight < 0.0 && difference < leastDifference : weight > bestWeight;
    if (isBetter) nearest = vec2(offset);
    if (isOther) leastDifference = min(leastDifference, difference);
    else bestWeight = max(bestWeight, weight);
  }
  isInterpolated = otherWeight < NEGLIGIBLE ? 1.0 : 0.0;
  return isInterpolated > 0.5 ? fraction : nearest;
}

void main() {
  vec2 size = vec2(textureSize(uAlbedo, 0));
  vec2 pixels = size / float(SAMPLES);
  vec2 corner = floor(gl_FragCoord.xy / pixels * uLightingSize - 0.5);
  ivec2 first = ivec2(gl_FragCoord.xy) * SAMPLES;
  vec3 albedo = vec3(0.0);
  vec4 guide = vec4(0.0);  // in zw how many are interpolated, and how many there are
  float depth = 1.0;
  for (int i = 0; i < SAMPLES * SAMPLES; i++) {
    ivec2 texel = first + ivec2(i % SAMPLES, i / SAMPLES);
    vec3 root = texelFetch(uAlbedo, texel, 0).rgb;
    albedo += root * root;
    vec4 surface = texelFetch(uGBufferSurface, texel, 0);
    float weight = isGlass(surface.a) ? PANE_WEIGHT : 1.0;
    float isInterpolated;
    guide.xy += weight * guideOf(texel, surface, corner, size, isInterpolated);
    guide.zw += weight * vec2(isInterpolated, 1.0);
    depth = min(depth, texelFetch(uDepth, texel, 0).r);
  }
  const float COUNT = float(SAMPLES * SAMPLES);
  guide /= guide.w;
  vec2 steps = floor(guide.xy * GUIDE_STEPS + 0.5);
  float code = guide.z > 0.9 ? 0.0 : 1.0 + steps.x + steps.y * (GUIDE_STEPS + 1.0);
  oAlbedo = vec4(sqrt(albedo / COUNT), code / 255.0);
  gl_FragDepth = depth;
}
