#version 300 es
// Out: base colour of what a probe's ray met, as coarsely as the ray sees it, less what its relief hides.
#include "lib/precision.glsl"
#include "lib/normal-map.glsl"

uniform sampler2D uAlbedo;
uniform sampler2D uNormal;
uniform vec4 uBaseColor;
uniform float uRelief;  // scale of the normals

// Texels along an edge of the level that is read.
const float COARSE = 16.0;

in vec2 vUv;

out vec4 oBaseColor;

void main() {
  float level = log2(max(float(textureSize(uAlbedo, 0).x) / COARSE, 1.0));
  vec3 baseColor = textureLod(uAlbedo, vUv, level).rgb * uBaseColor.rgb;
  oBaseColor = vec4(baseColor * meanSkyVisibility(uNormal, vUv, uRelief), 1.0);
}
