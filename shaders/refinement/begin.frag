#version 300 es
// First state of the refined image: surfaces of the same view by deferred shading.
// In:  radiance, cd/m², and its depth.   Out: radiance per candela, depth.
#include "lib/precision.glsl"
#include "lib/flame-light.glsl"

uniform sampler2D uRadiance;
uniform sampler2D uDepth;

in vec2 vUv;

out vec4 oRadiance;

// A flame that is out lights nothing, cd.
const float LEAST_INTENSITY = 1e-6;

void main() {
  oRadiance = vec4(texture(uRadiance, vUv).rgb / max(light.intensity, LEAST_INTENSITY), 1.0);
  // Less than the cleared depth, or the test would reject it.
  gl_FragDepth = min(texture(uDepth, vUv).r, 0.9999999);
}
