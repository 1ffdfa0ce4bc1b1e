// The surfaces that the flame sees, as small flat patches: faces of a cube, side by side along x.
// Needs lib/photometry.glsl, lib/flame-light.glsl.

uniform sampler2D uSurfelNormalDistance;

const int FACE_COUNT = 6;

struct Surfel {
  vec3 position;  // m
  vec3 normal;
  float area;     // m²
  float solidAngle;  // seen from the flame, sr
  float distance; // from the flame, m; 0 where there is nothing
};

// GL's cube faces.
vec3 faceDirection(int face, vec2 st) {
  if (face == 0) return vec3(1.0, -st.y, -st.x);
  if (face == 1) return vec3(-1.0, -st.y, st.x);
  if (face == 2) return vec3(st.x, 1.0, st.y);
  if (face == 3) return vec3(st.x, -1.0, -st.y);
  if (face == 4) return vec3(st.x, -st.y, 1.0);
  return vec3(-st.x, -st.y, -1.0);
}

// Where a direction from the flame meets a face: across and up it, 0 to 1, and which it is.
vec3 cubeFaceUv(vec3 d) {
  vec3 reach = abs(d);
  int axis = reach.x >= max(reach.y, reach.z) ? 0 : reach.y >= reach.z ? 1 : 2;
  int face = 2 * axis + (d[axis] > 0.0 ? 0 : 1);
  vec2 across = axis == 0 ? vec2(-d.z * sign(d.x), -d.y) : axis == 1 ? vec2(d.x, d.z * sign(d.y)) : vec2(d.x * sign(d.z), -d.y);
  return vec3(0.5 + 0.5 * across / reach[axis], float(face));
}

// The patch that the flame sees in a direction.
ivec2 surfelTexel(vec3 d, int size) {
  vec3 place = cubeFaceUv(d);
  return min(ivec2(place.xy * float(size)), size - 1) + ivec2(int(place.z) * size, 0);
}

// A patch that is seen at a grazing angle is not endless.
float slantOf(float facing) {
  return max(facing, 0.15);
}

Surfel surfelAt(ivec2 texel, int size) {
  vec4 stored = texelFetch(uSurfelNormalDistance, texel, 0);
  int face = texel.x / size;
  vec2 st = (vec2(texel.x - face * size, texel.y) + 0.5) / float(size) * 2.0 - 1.0;
  vec3 direction = faceDirection(face, st);
  float squared = dot(direction, direction);
  // Of a texel of a cube of half-edge 1, seen from the middle.
  float solidAngle = 4.0 / float(size * size) / (squared * sqrt(squared));
  direction *= inversesqrt(squared);
  Surfel surfel;
  surfel.position = light.vantage + direction * stored.w;
  surfel.normal = stored.xyz;
  surfel.area = solidAngle * stored.w * stored.w / slantOf(dot(stored.xyz, -direction));
  surfel.solidAngle = solidAngle;
  surfel.distance = stored.w;
  return surfel;
}

// Whether what lies at `reach` (m) in a direction can be seen past a surface that was `met` close to that way: it
// reaches as far as its plane. Slack is a share of the distance, and metres.
bool isVisiblePast(vec3 met, vec3 normal, vec3 direction, float reach) {
  float facing = dot(normal, direction);
  float end = max(length(met), facing < -1e-3 ? dot(normal, met) / facing : 0.0);
  return reach <= end + 0.07 * reach + 0.02;
}
