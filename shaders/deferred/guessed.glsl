// Where a pixel is to take its light from while the eye moves: from all around where all is as far away
// as it is, else from the texel that is most so.
// Needs physical/depth.glsl, deferred/stored.glsl.

uniform sampler2D uLight;

// Most that places of one surface differ, as a share of their distance.
const float ALIKE = 0.08;

vec2 guided(vec2 uv, float _) {
  vec2 size = vec2(textureSize(uLight, 0));
  vec2 pixels = vec2(textureSize(uDepth, 0));
  // Inverse distances, which change evenly across a plane, but for a factor.
  const float INFINITE = FAR_PLANE / (FAR_PLANE - NEAR_PLANE);
  float here = INFINITE - textureLod(uDepth, uv, 0.0).r;
  vec2 corner = floor(uv * size - 0.5);
  ivec2 low = pixelOf(ivec2(max(corner, 0.0)), size, pixels);
  ivec2 high = pixelOf(ivec2(min(corner + 1.0, size - 1.0)), size, pixels);
  vec4 around = INFINITE - vec4(
    texelFetch(uDepth, low, 0).r,
    texelFetch(uDepth, ivec2(high.x, low.y), 0).r,
    texelFetch(uDepth, ivec2(low.x, high.y), 0).r,
    texelFetch(uDepth, high, 0).r
  );
  vec4 apart = abs(around - here);
  vec2 pairs = max(apart.xy, apart.zw);
  if (max(pairs.x, pairs.y) < ALIKE * here) return uv;
  vec2 rows = min(apart.xy, apart.zw);
  float column = step(rows.y, rows.x);
  float row = column > 0.5 ? step(apart.w, apart.y) : step(apart.z, apart.x);
  return (corner + 0.5 + vec2(column, row)) / size;
}
