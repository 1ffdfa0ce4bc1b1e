#version 300 es
// In:  thickness of the smoke.   Out: radiance, cd/m², premultiplied by opacity.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/depth.glsl"

// What ends at a surface fades over this way before it, m.
const float SOFT = 0.03;

in vec3 vRadiance;
in float vThickness;
in float vAcross;

out vec4 oRadiance;

void main() {
  float thickness = vThickness * exp(-0.5 * vAcross * vAcross);
  float opacity = (1.0 - exp(-thickness)) * softParticleFade(SOFT);
  oRadiance = vec4(min(vRadiance, 3e4) * opacity, opacity);
}
