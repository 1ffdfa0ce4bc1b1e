// Where a pixel is to take its light from while the eye moves: from all around where that is as far away in
// the mean as it is, else from the texel that is most so.
// Needs physical/depth.glsl, deferred/stored.glsl.

uniform sampler2D uLight;
uniform sampler2D uNearness;  // of the light's texels

// Most that places of one surface differ, as a share of their distance.
const float ALIKE = 0.03;

vec2 guided(vec2 uv, float _) {
  float here = nearnessOf(textureLod(uDepth, uv, 0.0).r);
  // Across a plane the inverse of the distance changes evenly.
  // No early return: a CPU would go on with what comes after it.
  if (abs(textureLod(uNearness, uv, 0.0).r - here) >= ALIKE * here) {
    vec2 size = vec2(textureSize(uLight, 0));
    vec2 corner = floor(uv * size - 0.5);
    ivec2 low = ivec2(max(corner, 0.0));
    ivec2 high = ivec2(min(corner + 1.0, size - 1.0));
    vec4 apart = abs(here - vec4(
      texelFetch(uNearness, low, 0).r,
      texelFetch(uNearness, ivec2(high.x, low.y), 0).r,
      texelFetch(uNearness, ivec2(low.x, high.y), 0).r,
      texelFetch(uNearness, high, 0).r
    ));
    vec2 rows = min(apart.xy, apart.zw);
    float column = step(rows.y, rows.x);
    float row = column > 0.5 ? step(apart.w, apart.y) : step(apart.z, apart.x);
    uv = (corner + 0.5 + vec2(column, row)) / size;
  }
  return uv;
}
