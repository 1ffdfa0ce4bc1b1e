#version 300 es
// The light of the dimmer of two pictures that are kept, so that the frame's lies in their middle.
// Out: red: exposed intensity.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/flame-light.glsl"
#include "lib/photometry.glsl"
#include "lib/refined-light.glsl"

uniform sampler2D uExposure;  // stops, from the meter
uniform float uAutoExposure;  // 1, or 0 for a fixed exposure

out vec4 oReference;

// A flame that is out, cd.
const float LEAST_INTENSITY = 1e-3;

void main() {
  float exposure = frame.exposure * exp2(uAutoExposure * texelFetch(uExposure, ivec2(0), 0).r);
  float exposed = exposure * max(luma(light.intensity), LEAST_INTENSITY);
  oReference = vec4(exposed * inversesqrt(REFERENCE_RATIO), 0.0, 0.0, 1.0);
}
