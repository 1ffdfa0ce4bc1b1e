// Where a pixel is to take its light from while the eye moves: from all around where that is as far away in
// the mean as it is, else from the texels that are most so.
// Needs physical/depth.glsl, deferred/stored.glsl.

uniform sampler2D uLight;
uniform sampler2D uCorners;  // how near the light's texels are: deferred/corners.frag
// From places in the picture to those in the one before, if the light is of that.
uniform mat4 uSince;

// Most that places of one surface differ, as a share of their distance.
const float ALIKE = 0.03;
// What a texel of another surface counts for, where no better one is.
const float STRANGE = 0.01;

// Chosen, not branched for: that costs a CPU less.
vec2 guided(vec2 uv, float stored) {
  vec3 place = vec3(uv, texture(uDepth, uv).r);
  vec4 since = uSince * vec4(place, 1.0);
  if (stored < 0.5 * CARRIED) place = since.xyz / since.w;
  float here = nearnessOf(place.z);
  vec2 size = vec2(textureSize(uLight, 0));
  vec2 at = clamp(place.xy * size - 0.5, vec2(0.0), size - 1.0);
  vec2 corner = floor(at);
  vec2 share = at - corner;
  vec4 nearness = texelFetch(uCorners, ivec2(corner), 0);
  vec2 rows = mix(nearness.xz, nearness.yw, share.x);
  // Across a plane the inverse of the distance changes evenly.
  bool isAlike = abs(mix(rows.x, rows.y, share.y) - here) < ALIKE * here;
  vec4 weights = max(ALIKE * here - abs(nearness - here), STRANGE * ALIKE * here);
  weights *= vec4(1.0 - share.x, share.x, 1.0 - share.x, share.x);
  weights *= vec4(1.0 - share.yy, share.yy);
  vec2 chosen = vec2(weights.y + weights.w, weights.z + weights.w) / dot(weights, vec4(1.0));
  return (corner + 0.5 + (isAlike ? share : chosen)) / size;
}
