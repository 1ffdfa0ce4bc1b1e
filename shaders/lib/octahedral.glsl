// Octahedral map: directions mapped to a square, with up at the centre and down at the corners.
// Cigolle et al. 2014, "A Survey of Efficient Representations for Independent Unit Vectors".

vec2 octahedralFold(vec2 e) {
  return (1.0 - abs(e.yx)) * vec2(e.x < 0.0 ? -1.0 : 1.0, e.y < 0.0 ? -1.0 : 1.0);
}

// uv of a direction.
vec2 octahedralEncode(vec3 direction) {
  vec3 d = direction / (abs(direction.x) + abs(direction.y) + abs(direction.z));
  return (d.y < 0.0 ? octahedralFold(d.xz) : d.xz) * 0.5 + 0.5;
}

// Its inverse: a point of the octahedron |x| + |y| + |z| = 1. A uv beyond an edge continues across it.
vec3 octahedralDecode(vec2 uv) {
  vec2 e = uv * 2.0 - 1.0;
  if (abs(e.x) > 1.0) e = vec2(sign(e.x) * 2.0 - e.x, -e.y);
  if (abs(e.y) > 1.0) e = vec2(-e.x, sign(e.y) * 2.0 - e.y);
  float y = 1.0 - abs(e.x) - abs(e.y);
  vec2 level = y < 0.0 ? octahedralFold(e) : e;
  return vec3(level.x, y, level.y);
}
