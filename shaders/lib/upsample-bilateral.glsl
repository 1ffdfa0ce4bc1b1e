// Where a pixel is to take its paint and its light from while the eye moves. Places are across, up, depth.
// Paint: its own, or HISTORY, that of the picture before, which the light is of, too. Light: from all around where
// that is as far away in the mean as the paint is, else from the texels that are most so.
// Needs lib/depth.glsl, lib/gbuffer.glsl, and HISTORY lib/reproject.glsl.

uniform sampler2D uGBufferAlbedo;
uniform sampler2D uLight;
uniform sampler2D uNearnessGather;  // how near the light's texels are: opaque/gather-nearness.frag

// Most that places of one surface differ, as a share of their distance.
const float ALIKE = 0.03;
// What a texel of another surface counts for, where no better one is.
const float STRANGE = 0.01;

// Chosen, not branched for, here and below: that costs a CPU less.
#if HISTORY
// Where a pixel's surface was as it was painted: as far away as what was seen there. Its paint is put in place
// of what the pixel had. What was hidden behind something carried has only that to show, and keeps its own.
vec3 found(vec2 uv, inout vec4 painted) {
  vec4 here = vec4(uv, texture(uDepth, uv).r, 1.0);
  float isHeld = carried(painted.a);
  vec2 there = previousUv(here, isHeld);
  vec4 before = texture(uGBufferAlbedo, there);
  float stays = isDisoccluded(isHeld, before.a);
  painted = mix(before, painted, stays);
  return mix(vec3(there, texture(uDepth, there).r), here.xyz, stays);
}

// The depth now of what was found.
float depthOf(vec2 uv) {
  vec4 painted = texture(uGBufferAlbedo, uv);
  mat4 since = carried(painted.a) > 0.5 ? uPreviousFromCurrentHeld : uPreviousFromCurrentRoom;
  float before = found(uv, painted).z;
  vec4 near = since * vec4(uv, 0.0, 1.0);
  return (before * near.w - near.z) / (since[2].z - before * since[2].w);
}
#else
vec3 found(vec2 uv, vec4 painted) {
  return vec3(uv, texture(uDepth, uv).r);
}

float depthOf(vec2 uv) {
  return texture(uDepth, uv).r;
}
#endif

vec2 lightingUv(vec2 uv, inout vec4 painted) {
  vec3 place = found(uv, painted);
  float here = nearnessOf(place.z);
  vec2 size = vec2(textureSize(uLight, 0));
  vec2 at = clamp(place.xy * size - 0.5, vec2(0.0), size - 1.0);
  vec2 corner = floor(at);
  vec2 share = at - corner;
  vec4 nearness = texelFetch(uNearnessGather, ivec2(corner), 0);
  vec2 rows = mix(nearness.xz, nearness.yw, share.x);
  // Across a plane the inverse of the distance changes evenly.
  bool isAlike = abs(mix(rows.x, rows.y, share.y) - here) < ALIKE * here;
  vec4 weights = max(ALIKE * here - abs(nearness - here), STRANGE * ALIKE * here);
  weights *= vec4(1.0 - share.x, share.x, 1.0 - share.x, share.x);
  weights *= vec4(1.0 - share.yy, share.yy);
  vec2 chosen = vec2(weights.y + weights.w, weights.z + weights.w) / dot(weights, vec4(1.0));
  return (corner + 0.5 + (isAlike ? share : chosen)) / size;
}
