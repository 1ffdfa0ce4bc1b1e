#version 300 es
// Composite of the forward stage: radiance per candela times the flame's intensity.
// In:  radiance per candela, or normals to inspect.   Out: radiance, cd/m².
#include "lib/precision.glsl"
#include "lib/flame-light.glsl"

uniform sampler2D uRadiance;
uniform float uIsLight;  // 0: normals

out vec4 oRadiance;

void main() {
  vec3 radiance = texelFetch(uRadiance, ivec2(gl_FragCoord.xy), 0).rgb;
  // The largest half float is 65504; a mirrored flame can be brighter.
  oRadiance = vec4(min(radiance * mix(vec3(1.0), light.intensity, uIsLight), 3e4), 1.0);
}
