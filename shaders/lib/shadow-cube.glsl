// Shadow cube: depth of the nearest caster in every direction from the capture origin. Its faces are tiles of one
// texture, a column for each axis and a row for each sign; cubes of several flames lie one above another:
// src/render/shadow/shadow-pass.ts. Needs lib/flame-light.glsl.
//
// A face's depth is 1 - SHADOW_NEAR / distance along its axis. It is linear across a plane, so that the depth of a lit
// surface in any texel is a dot product.

// Width of a tile as a share of the face's: taps beyond the face's edges stay in its tile.
const float SHADOW_REACH = 1.125;
const float SHADOW_NEAR = 0.04;  // m
// Step of the stored depth, 16 bits.
const float SHADOW_STEP = 1.0 / 65535.0;

uniform sampler2D uShadow;
#ifdef CANDLES
uniform sampler2D uStandingShadow;  // cubes of the standing candles, of the same size
#endif

// Whether a direction's face has the axis x, or y.
bvec2 shadowAxis(vec3 direction) {
  vec3 magnitude = abs(direction);
  return bvec2(magnitude.x >= max(magnitude.y, magnitude.z), magnitude.y >= magnitude.z);
}

// A vector by the axes of a face: across, up, along its axis.
vec3 onShadowFace(vec3 v, bvec2 axis) {
  return axis.x ? v.yzx : axis.y ? v.zxy : v;
}

// Center of a face's tile, texels. `along`: component along the face's axis. `tile`: texels along its edge.
vec2 shadowTileCenter(bvec2 axis, float along, float tile) {
  return (vec2(axis.x ? 0.5 : axis.y ? 1.5 : 2.5, 2.0 * light.shadowSlot + (along > 0.0 ? 0.5 : 1.5))) * tile;
}

// Texels along a tile's edge.
float shadowTileSize() {
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
  vec2 texel = shadowTileCenter(axis, d.z, tile) + d.xy / d.z * (0.5 * tile / SHADOW_REACH);
  float depth = shadowDepth(texel);
  return SHADOW_NEAR / (abs(d.z) * max(1.0 - depth, SHADOW_STEP));
}
