// Faces of shadow cubes as tiles of one texture, a column for each axis and a row for each sign; cubes of several lights
// lie one above another: src/render/shadow/shadow-pass.ts.
//
// A face's depth is 1 - SHADOW_NEAR / distance along its axis. It is linear across a plane, so that the depth of a lit
// surface in any texel is a dot product.

// Width of a tile as a share of the face's: taps beyond the face's edges stay in its tile.
const float SHADOW_REACH = 1.125;
// What is nearer to a light casts no shadow, m: a candle's own parts.
#ifndef SHADOW_NEAR
const float SHADOW_NEAR = 0.04;
#endif
// Step of the stored depth, 16 bits.
const float SHADOW_STEP = 1.0 / 65535.0;

// Whether a direction's face has the axis x, or y.
bvec2 shadowAxis(vec3 direction) {
  vec3 magnitude = abs(direction);
  return bvec2(magnitude.x >= max(magnitude.y, magnitude.z), magnitude.y >= magnitude.z);
}

// A vector by the axes of a face: across, up, along its axis.
vec3 onShadowFace(vec3 v, bvec2 axis) {
  return axis.x ? v.yzx : axis.y ? v.zxy : v;
}

// Center of a face's tile, texels. `along`: component along the face's axis. `slot`: of the cube. `tile`: texels along
// its edge.
vec2 shadowTileCenter(bvec2 axis, float along, float slot, float tile) {
  return vec2(axis.x ? 0.5 : axis.y ? 1.5 : 2.5, 2.0 * slot + (along > 0.0 ? 0.5 : 1.5)) * tile;
}
