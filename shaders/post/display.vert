#version 300 es
// Fullscreen triangle, with the exposure of the frame.
#include "lib/precision.glsl"
#include "lib/frame.glsl"

uniform sampler2D uExposure;  // stops, from the meter
uniform float uAutoExposure;  // 1, or 0 for a fixed exposure

out vec2 vUv;
flat out float vExposure;  // factor on radiance, white is about 1

void main() {
  vUv = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
  gl_Position = vec4(vUv * 2.0 - 1.0, 0.0, 1.0);
  vExposure = frame.exposure * exp2(uAutoExposure * texelFetch(uExposure, ivec2(0), 0).r);
}
