#version 300 es
// A base colour as paint keeps it, so that who reads it has no curve to undo: software takes four times as
// long for a texel of sRGB as for one of plain bytes.
// In:  base colour (sRGB).   Out: its root; opacity.
#include "lib/precision.glsl"

uniform sampler2D uAlbedo;

in vec2 vUv;

out vec4 oRoot;

void main() {
  vec4 albedo = texture(uAlbedo, vUv);
  oRoot = vec4(sqrt(albedo.rgb), albedo.a);
}
