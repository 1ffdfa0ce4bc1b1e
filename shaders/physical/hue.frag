#version 300 es
// Out: base colour of what a probe's ray met, as coarsely as the ray sees it.
#include "lib/precision.glsl"

uniform sampler2D uAlbedo;
uniform vec4 uBaseColor;

// Texels along an edge of the level that is read.
const float COARSE = 16.0;

in vec2 vUv;

out vec4 oBaseColor;

void main() {
  float level = log2(max(float(textureSize(uAlbedo, 0).x) / COARSE, 1.0));
  oBaseColor = vec4(textureLod(uAlbedo, vUv, level).rgb * uBaseColor.rgb, 1.0);
}
