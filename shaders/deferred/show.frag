#version 300 es
// The room's light on the screen, straight away: the display's law is looked up in a table.
// In:  paint, light, bloom.   Out: display colour.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/random.glsl"
#include "physical/light.glsl"
#include "deferred/stored.glsl"
#include "deferred/lit.glsl"
#include "deferred/table.glsl"

precision highp sampler3D;

uniform sampler3D uTable;
uniform sampler2D uBloom;
uniform float uScattered;  // share of the light that eye and lens scatter

in vec2 vUv;

out vec4 oColor;

void main() {
  vec3 radiance = litAt(vUv) + textureLod(uBloom, vUv, 0.0).rgb * uScattered;
  vec3 exposed = radiance * (frame.exposure / TABLE_LIGHT);
  // What is brighter than the table keeps its hue.
  exposed /= max(max(exposed.r, exposed.g), max(exposed.b, 1.0));
  vec3 place = sqrt(exposed);
  vec3 color = textureLod(uTable, place * ((TABLE_SIZE - 1.0) / TABLE_SIZE) + 0.5 / TABLE_SIZE, 0.0).rgb;
  // Noise of one 8-bit step, the same for all channels.
  uint hash = pcg(uint(gl_FragCoord.x) + uint(gl_FragCoord.y) * 4096u);
  float noise = float(hash & 65535u) + float(hash >> 16u) - 65535.0;
  oColor = vec4(color + noise * (1.0 / (65536.0 * 255.0)), 1.0);
}
