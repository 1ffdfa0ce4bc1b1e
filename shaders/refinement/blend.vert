#version 300 es
// Fullscreen triangle, with the weights of the two kept lights for the frame's. REPROJECTED, 0 or 1: and with the place on
// the refined image of what is at depth 0.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/flame-light.glsl"
#include "lib/photometry.glsl"
#include "lib/refined-light.glsl"

uniform sampler2D uExposure;   // stops, from the meter
uniform sampler2D uReference;  // log2 of the intensity that the dimmer image is exposed for, times its exposure
uniform float uAutoExposure;   // 1, or 0 for a fixed exposure

#ifdef REPROJECTED
uniform mat4 uRefinedFromCurrentRoom;
uniform mat4 uRefinedFromCurrentHeld;

out vec4 vRoom;
out vec4 vHeld;
#endif
out vec2 vUv;
flat out float vExposure;  // factor on radiance, white is about 1
flat out float vShare;     // of the brighter image

void main() {
  vUv = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
  gl_Position = vec4(vUv * 2.0 - 1.0, 0.0, 1.0);
#ifdef REPROJECTED
  vRoom = uRefinedFromCurrentRoom * vec4(vUv, 0.0, 1.0);
  vHeld = uRefinedFromCurrentHeld * vec4(vUv, 0.0, 1.0);
#endif
  vExposure = frame.exposure * exp2(uAutoExposure * texelFetch(uExposure, ivec2(0), 0).r);
  float ratio = vExposure * luma(light.intensity) / (frame.exposure * exp2(texelFetch(uReference, ivec2(0), 0).r));
  // Display colours rise with about this power of the light: then the mixture is right everywhere, and near it beyond.
  vShare = (pow(ratio, DISPLAY_POWER) - 1.0) / (pow(REFERENCE_RATIO, DISPLAY_POWER) - 1.0);
}
