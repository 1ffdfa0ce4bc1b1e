// The surfaces that the flame sees, as small flat patches: faces of a cube, side by side along x.
// Needs lib/photometry.glsl, physical/light.glsl.

uniform sampler2D uNormalDistance;

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

Surfel surfelAt(ivec2 texel, int size) {
  vec4 stored = texelFetch(uNormalDistance, texel, 0);
  int face = texel.x / size;
  vec2 st = (vec2(texel.x - face * size, texel.y) + 0.5) / float(size) * 2.0 - 1.0;
  vec3 direction = faceDirection(face, st);
  float squared = dot(direction, direction);
  // Of a texel of a cube of half-edge 1, seen from the middle.
  float solidAngle = 4.0 / float(size * size) / (squared * sqrt(squared));
  direction *= inversesqrt(squared);
  float facing = max(dot(stored.xyz, -direction), 0.15);  // a grazing patch is not endless
  Surfel surfel;
  surfel.position = light.vantage + direction * stored.w;
  surfel.normal = stored.xyz;
  surfel.area = solidAngle * stored.w * stored.w / facing;
  surfel.solidAngle = solidAngle;
  surfel.distance = stored.w;
  return surfel;
}
