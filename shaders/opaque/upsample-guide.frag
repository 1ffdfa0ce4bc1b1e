#version 300 es
// Where each pixel is to take its light from: the four texels of light around it are mixed where all lie
// on its own surface; else the nearest that does. Where a pixel sees several surfaces, their places are
// averaged, so that an edge mixes the light of both sides as it mixes their colours.
// In:  surfaces and depth, SAMPLES x SAMPLES for each pixel.
// Out: root of the albedo; in alpha the place among the four texels. Depth.
// After Kopf, Cohen, Lischinski and Uyttendaele 2007, "Joint Bilateral Upsampling", decided once for a
// still picture instead of weighed anew for each frame.
#include "lib/precision.glsl"
#include "lib/depth.glsl"
#include "lib/gbuffer.glsl"
#include "lib/representative-sample.glsl"

uniform sampler2D uAlbedo;
uniform sampler2D uGBufferSurface;
uniform vec2 uLightingSize;

out vec4 oPainted;

// Most that two places of one surface differ, as shares of distance and of the octahedron's square.
const float STEP = 0.02;
const float TURN = 0.06;
// A texel that counts for less than this is no reason not to mix.
const float LITTLE = 0.04;

float nearness(ivec2 at) {
  return 1.0 / linearDepth(texelFetch(uDepth, at, 0).r);
}

// Of two differences the smaller: the other one may cross an edge.
float slope(float before, float here, float after) {
  return abs(after - here) < abs(here - before) ? after - here : here - before;
}

// Place of a sample among the texels from `corner` on, 0 to 1.
vec2 placeOf(ivec2 at, vec2 corner, vec2 size, out float mixes) {
  vec2 way = texelFetch(uGBufferSurface, at, 0).rg;
  ivec2 last = ivec2(size) - 1;
  // Across a plane the inverse of the distance changes evenly.
  float here = nearness(at);
  vec2 slopes = vec2(
    slope(nearness(max(at - ivec2(1, 0), 0)), here, nearness(min(at + ivec2(1, 0), last))),
    slope(nearness(max(at - ivec2(0, 1), 0)), here, nearness(min(at + ivec2(0, 1), last)))
  );
  vec2 share = clamp((vec2(at) + 0.5) / size * uLightingSize - 0.5 - corner, 0.0, 1.0);
  float strange = 0.0;
  float best = -1.0;
  float least = 1e9;
  vec2 nearest = vec2(0.0);
  for (int i = 0; i < 4; i++) {
    ivec2 offset = ivec2(i & 1, i >> 1);
    ivec2 texel = clamp(ivec2(corner) + offset, ivec2(0), ivec2(uLightingSize) - 1);
    ivec2 other = representativeSample(texel, uLightingSize, ivec2(size));
    float expected = here + dot(vec2(other - at), slopes);
    float apart = abs(nearness(other) - expected) / here;
    vec2 turned = abs(texelFetch(uGBufferSurface, other, 0).rg - way);
    float difference = apart / STEP + (turned.x + turned.y) / TURN;
    vec2 shares = mix(1.0 - share, share, vec2(offset));
    float weight = shares.x * shares.y;
    bool isStrange = difference > 2.0;
    if (isStrange) strange += weight;
    // Among its own the nearest; among strangers the least strange.
    bool isBetter = isStrange ? best < 0.0 && difference < least : weight > best;
    if (isBetter) nearest = vec2(offset);
    if (isStrange) least = min(least, difference);
    else best = max(best, weight);
  }
  mixes = strange < LITTLE ? 1.0 : 0.0;
  return mixes > 0.5 ? share : nearest;
}

void main() {
  vec2 size = vec2(textureSize(uAlbedo, 0));
  vec2 pixels = size / float(SAMPLES);
  vec2 corner = floor(gl_FragCoord.xy / pixels * uLightingSize - 0.5);
  ivec2 first = ivec2(gl_FragCoord.xy) * SAMPLES;
  vec3 albedo = vec3(0.0);
  vec2 place = vec2(0.0);
  float mixing = 0.0;
  float depth = 1.0;
  for (int i = 0; i < SAMPLES * SAMPLES; i++) {
    ivec2 at = first + ivec2(i % SAMPLES, i / SAMPLES);
    vec3 root = texelFetch(uAlbedo, at, 0).rgb;
    albedo += root * root;
    float mixes;
    place += placeOf(at, corner, size, mixes);
    mixing += mixes;
    depth = min(depth, texelFetch(uDepth, at, 0).r);
  }
  const float COUNT = float(SAMPLES * SAMPLES);
  vec2 steps = floor(place / COUNT * GUIDE_STEPS + 0.5);
  float code = mixing > COUNT - 0.5 ? 0.0 : 1.0 + steps.x + steps.y * (GUIDE_STEPS + 1.0);
  oPainted = vec4(sqrt(albedo / COUNT), code / 255.0);
  gl_FragDepth = depth;
}
