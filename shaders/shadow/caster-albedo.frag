#version 300 es
// One surface's tile of the caster albedo.
// Out: reflectance for light from all around, less the self-occlusion of the normal map; gloss.
#include "lib/precision.glsl"
#include "lib/reflectance.glsl"
#include "lib/normal-map.glsl"
#include "lib/relief.glsl"
#include "lib/caster-albedo.glsl"
#include "lib/material.glsl"

uniform float uTile;  // its number

out vec4 oReflectance;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy) - casterTile(int(uTile));
  int level = 0;
  for (int i = 1; i < CASTER_LEVELS; i++) if (texel.y >= casterLevelRow(i)) level = i;
  texel.y -= casterLevelRow(level);
  int size = casterLevelSize(level);
  // Unused: beside the coarser levels, and above the last.
  if (max(texel.x, texel.y) >= size) discard;
  vec2 uv = (vec2(texel) + 0.5) / float(size);
  vec2 footprint = vec2(1.0 / float(size), 0.0);
  vec3 baseColor = textureGrad(uAlbedo, uv, footprint, footprint.yx).rgb * uBaseColor.rgb;
  int blocks = 1 << level;
  float visibility = 0.0;
  for (int y = 0; y < blocks; y++) {
    for (int x = 0; x < blocks; x++) {
      vec2 block = (vec2(texel * blocks + ivec2(x, y)) + 0.5) / float(CASTER_TILE);
      visibility += meanSkyVisibility(uNormal, block, uSurface.z);
    }
  }
  baseColor *= visibility / float(blocks * blocks);
  vec2 roughnessMetallic = textureGrad(uOcclusionRoughness, uv, footprint, footprint.yx).gb * uSurface.xy;
  oReflectance = reflectanceAndGloss(baseColor, roughnessMetallic.x, roughnessMetallic.y);
}
