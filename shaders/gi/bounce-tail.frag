#version 300 es
// Tail of the series of bounces: after a few, each is the last one times a ratio r that is nearly the same everywhere,
// the reflectance of the room. What follows the last is it times r + r^2 + ... = r / (1 - r).
// In:  spherical harmonics after the last three bounces, of which the mean radiance at a sample of the probes.
// Out: r / (1 - r), by channel.
#include "lib/precision.glsl"
#include "lib/photometry.glsl"
#include "lib/sh.glsl"

uniform sampler2D uLast;
uniform sampler2D uPrevious;
uniform sampler2D uBefore;

out vec4 oTail;

const int PROBES = 128;
const int STRIDE = 37;  // prime, so that the sample is spread
// A room that reflects more than this would take many bounces to settle.
const float MOST = 0.95;

void main() {
  ivec2 size = textureSize(uLast, 0) / ivec2(SH_TEXELS, 1);
  int count = size.x * size.y;
  vec3 last = vec3(0.0);
  vec3 previous = vec3(0.0);
  for (int i = 0; i < PROBES; i++) {
    int probe = (i * STRIDE) % count;
    ivec2 texel = ivec2((probe % size.x) * SH_TEXELS, probe / size.x);
    vec3 sum = texelFetch(uPrevious, texel, 0).rgb;
    last += max(texelFetch(uLast, texel, 0).rgb - sum, 0.0);
    previous += max(sum - texelFetch(uBefore, texel, 0).rgb, 0.0);
  }
  vec3 ratio = clamp(last / max(previous, 1e-9), 0.0, MOST);
  oTail = vec4(ratio / (1.0 - ratio), 1.0);
}
