// Where a pixel is to take its light from while the eye moves: from all around where that is as far away in
// the mean as it is, else from the texel that is most so.
// Needs physical/depth.glsl, deferred/stored.glsl.

uniform sampler2D uLight;
uniform sampler2D uNearness;  // of the light's texels
// From places in the picture to those in the one before, if the light is of that.
uniform mat4 uSince;

// Most that places of one surface differ, as a share of their distance.
const float ALIKE = 0.03;

vec2 guided(vec2 uv, float stored) {
  vec3 place = vec3(uv, textureLod(uDepth, uv, 0.0).r);
  vec4 since = uSince * vec4(place, 1.0);
  if (stored < 0.5 * CARRIED) place = since.xyz / since.w;
  vec2 now = uv;
  uv = place.xy;
  float here = nearnessOf(place.z);
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
    // What the candle hid in the picture before is more like what is beside it.
    float least = min(min(apart.x, apart.y), min(apart.z, apart.w));
    if (least > 3.0 * ALIKE * here) {
      if (abs(textureLod(uNearness, now, 0.0).r - here) < least) uv = now;
    }
  }
  return uv;
}
