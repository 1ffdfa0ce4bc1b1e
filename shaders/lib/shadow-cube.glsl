// Shadow cube: depth of the nearest caster in every direction from the capture origin. Needs lib/flame-light.glsl.
#include "lib/shadow-tiles.glsl"

uniform sampler2D uShadow;
#ifdef CANDLES
uniform sampler2D uStandingShadow;  // cubes of the standing candles; many are smaller
#endif

// Texels along a tile's edge.
float shadowTileSize() {
#ifdef CANDLES
  if (isStanding) return float(textureSize(uStandingShadow, 0).x / 3);
#endif
  return float(textureSize(uShadow, 0).x / 3);
}

// Depth in a texel of the cube of the flame that is shaded for.
float shadowDepth(vec2 texel) {
#ifdef CANDLES
  if (isStanding) return texelFetch(uStandingShadow, ivec2(texel), 0).r;
#endif
  return texelFetch(uShadow, ivec2(texel), 0).r;
}

// Distance of the nearest caster in a direction, as a multiple of the direction's length.
float casterDistance(vec3 direction) {
  bvec2 axis = shadowAxis(direction);
  vec3 d = onShadowFace(direction, axis);
  float tile = shadowTileSize();
  vec2 texel = shadowTileCenter(axis, d.z, light.shadowSlot, tile) + d.xy / d.z * (0.5 * tile / SHADOW_REACH);
  float depth = shadowDepth(texel);
  return SHADOW_NEAR / (abs(d.z) * max(1.0 - depth, SHADOW_STEP));
}
