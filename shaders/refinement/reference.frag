#version 300 es
// One of the two lights that an image is kept in, so that the frame's lies in their middle.
// Out: red: log2 of the intensity, times the metered exposure.
#include "lib/precision.glsl"
#include "lib/flame-light.glsl"
#include "lib/photometry.glsl"
#include "lib/refined-light.glsl"

uniform sampler2D uExposure;  // stops, from the meter
uniform float uBrighter;       // 1 or 0
uniform float uAutoExposure;  // 1, or 0 for a fixed exposure

out vec4 oReference;

// A flame that is out, cd.
const float LEAST_INTENSITY = 1e-3;

void main() {
  float stops = uAutoExposure * texelFetch(uExposure, ivec2(0), 0).r + log2(max(luma(light.intensity), LEAST_INTENSITY));
  float span = log2(REFERENCE_RATIO);
  oReference = vec4(stops + (uBrighter - 0.5) * span, 0.0, 0.0, 1.0);
}
