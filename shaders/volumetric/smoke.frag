#version 300 es
// Smoke: a Gaussian profile across the ribbon.   Out: radiance, cd/m², premultiplied by opacity.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#ifndef ALONE
#include "lib/depth.glsl"
#endif

// Width of the soft-particle fade, m.
const float FADE = 0.03;

in vec3 vRadiance;
in float vOpticalDepth;
in float vAcross;

out vec4 oRadiance;

void main() {
  float opticalDepth = vOpticalDepth * exp(-0.5 * vAcross * vAcross);
  float opacity = 1.0 - exp(-opticalDepth);
#ifndef ALONE
  opacity *= softParticleFade(FADE);
#endif
  oRadiance = vec4(min(vRadiance, 3e4) * opacity, opacity);
}
