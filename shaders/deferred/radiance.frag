#version 300 es
// The room's light, where more is to be drawn over it.   Out: radiance, cd/m².
#include "lib/precision.glsl"
#include "physical/light.glsl"
#include "deferred/stored.glsl"
#include "deferred/lit.glsl"

in vec2 vUv;

out vec4 oRadiance;

void main() {
  oRadiance = vec4(min(litAt(vUv), 3e4), 1.0);
}
