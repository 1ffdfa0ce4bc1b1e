#version 300 es
// Limit of the series of bounces, from its last terms.
//
// Each bounce is a linear operator on the one before. After a few only its slowest parts are left: one for a closed
// room, two for rooms that are joined by a doorway. The limit is the weighted mean of the last three sums whose
// residual, the mean of the next bounces by the same weights, is least: reduced rank extrapolation, Mešina 1977,
// "Convergence Acceleration for the Iterative Solution of the Equations X = AX + f"; Smith, Ford and Sidi 1987,
// "Extrapolation Methods for Vector Sequences". Residuals count relative to the irradiance at their probe, so that dark
// rooms count as bright ones do.
// In:  irradiance after four bounces in a row, of which a texel at a sample of the probes.
// Out: weights of the sums before the last and before that, by channel; the last one has what is left of 1.
#include "lib/precision.glsl"

uniform sampler2D uLast;
uniform sampler2D uPrevious;
uniform sampler2D uBefore;
uniform sampler2D uFirst;

layout(location = 0) out vec4 oPreviousWeight;
layout(location = 1) out vec4 oBeforeWeight;

const int PROBES = 128;
const int STRIDE = 37;  // prime, so that the sample is spread
// Share of the residuals' squares that keeps weights small where two of three are enough.
const float RIDGE = 1e-4;
const float LARGEST_WEIGHT = 60.0;

void main() {
  ivec2 size = textureSize(uLast, 0) / IRRADIANCE_TEXELS;
  int count = size.x * size.y;
  vec3 aa = vec3(0.0);
  vec3 ab = vec3(0.0);
  vec3 bb = vec3(0.0);
  vec3 ar = vec3(0.0);
  vec3 br = vec3(0.0);
  for (int i = 0; i < PROBES; i++) {
    int probe = (i * STRIDE) % count;
    ivec2 place = ivec2(i, i / IRRADIANCE_TEXELS) % IRRADIANCE_TEXELS;
    ivec2 texel = ivec2(probe % size.x, probe / size.x) * IRRADIANCE_TEXELS + place;
    vec3 last = texelFetch(uLast, texel, 0).rgb;
    vec3 previous = texelFetch(uPrevious, texel, 0).rgb;
    vec3 before = texelFetch(uBefore, texel, 0).rgb;
    vec3 scale = 1.0 / max(last, 1e-9);
    vec3 residual = (last - previous) * scale;
    vec3 a = (previous - before) * scale - residual;
    vec3 b = (before - texelFetch(uFirst, texel, 0).rgb) * scale - residual;
    aa += a * a;
    ab += a * b;
    bb += b * b;
    ar += a * residual;
    br += b * residual;
  }
  vec3 ridge = RIDGE * (aa + bb) + 1e-12;
  aa += ridge;
  bb += ridge;
  vec3 determinant = max(aa * bb - ab * ab, 1e-24);
  vec3 previousWeight = (ab * br - bb * ar) / determinant;
  vec3 beforeWeight = (ab * ar - aa * br) / determinant;
  oPreviousWeight = vec4(clamp(previousWeight, -LARGEST_WEIGHT, LARGEST_WEIGHT), 1.0);
  oBeforeWeight = vec4(clamp(beforeWeight, -LARGEST_WEIGHT, LARGEST_WEIGHT), 1.0);
}
