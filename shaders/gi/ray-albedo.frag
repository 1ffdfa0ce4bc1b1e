#version 300 es
// Base colour at the hits of the probes' rays, at the mip level of a ray's footprint, less the self-occlusion of the
// normal map.
#include "lib/precision.glsl"
#include "lib/normal-map.glsl"

uniform sampler2D uAlbedo;
uniform sampler2D uNormal;
uniform vec4 uBaseColor;
uniform float uNormalScale;

// Texels along an edge of the mip level that is read.
const float FOOTPRINT_TEXELS = 16.0;

in vec2 vUv;

out vec4 oBaseColor;

void main() {
  float level = log2(max(float(textureSize(uAlbedo, 0).x) / FOOTPRINT_TEXELS, 1.0));
  vec3 baseColor = textureLod(uAlbedo, vUv, level).rgb * uBaseColor.rgb;
  oBaseColor = vec4(baseColor * meanSkyVisibility(uNormal, vUv, uNormalScale), 1.0);
}
