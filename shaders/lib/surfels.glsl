// Surfels: the surfaces that the flame lights, as flat patches, one a texel of a cube map whose faces lie side by side
// along x. Needs lib/flame-light.glsl.
// MOON: the surfaces that the moon lights, one a texel of its map, and in the last rows the panes that the sky
// shines through. Needs lib/moon.glsl instead.

uniform sampler2D uSurfelNormalDistance;

const int FACE_COUNT = 6;

struct Surfel {
  vec3 position;  // m
  vec3 normal;
  float area;     // m²
  float solidAngle;  // from the capture origin, sr
  float distance; // from the capture origin, m; 0 where there is no surface
};

// Direction through a point of a face, -1 to 1 along each edge, in GL's order of faces.
vec3 faceDirection(int face, vec2 st) {
  if (face == 0) return vec3(1.0, -st.y, -st.x);
  if (face == 1) return vec3(-1.0, -st.y, st.x);
  if (face == 2) return vec3(st.x, 1.0, st.y);
  if (face == 3) return vec3(st.x, -1.0, -st.y);
  if (face == 4) return vec3(st.x, -st.y, 1.0);
  return vec3(-st.x, -st.y, -1.0);
}

// Face that a direction meets.
int faceOf(vec3 d) {
  vec3 size = abs(d);
  int axis = size.x >= max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
  return 2 * axis + (d[axis] > 0.0 ? 0 : 1);
}

// A vector by the axes of a face: those of its edges, and its own.
vec3 onFace(vec3 v, int face) {
  float sense = 1.0 - 2.0 * float(face & 1);
  if (face < 2) return vec3(-v.z * sense, -v.y, v.x * sense);
  if (face < 4) return vec3(v.x, v.z * sense, v.y * sense);
  return vec3(v.x * sense, -v.y, v.z * sense);
}

// Texel of a surfel by its number, row by row; beyond the last row there is none.
ivec2 surfelOfIndex(int index, int size) {
  int columns = FACE_COUNT * size;
  return ivec2(index % columns, index / columns);
}

// Solid angle of the texel in a direction of length 1, from the capture origin, sr.
float surfelSolidAngle(vec3 direction) {
  vec3 size = abs(direction);
  float onFace = max(size.x, max(size.y, size.z));
  float texels = float(textureSize(uSurfelNormalDistance, 0).y);
  return 4.0 / (texels * texels) * onFace * onFace * onFace;
}

// Cosine at a surfel, limited so that the area at a grazing angle stays finite.
float limitedCosine(float cosine) {
  return max(cosine, 0.15);
}

#ifdef MOON
// Whether a texel is a part of the window's panes.
bool isPaneSurfel(ivec2 texel, int size) {
  return texel.y >= size - int(moon.paneRows);
}

Surfel surfelAt(ivec2 texel, int size) {
  vec4 normalDistance = texelFetch(uSurfelNormalDistance, texel, 0);
  vec2 place = (vec2(texel) + 0.5) / vec2(moon.surfelColumns, float(size) - moon.paneRows);
  Surfel surfel;
  surfel.position = moon.position + moon.across * place.x + moon.up * place.y + moon.direction * normalDistance.w;
  surfel.normal = normalDistance.xyz;
  surfel.solidAngle = moon.surfelArea;
  surfel.area = moon.surfelArea / limitedCosine(-dot(surfel.normal, moon.direction));
  surfel.distance = normalDistance.w;
  if (isPaneSurfel(texel, size)) {
    place = (vec2(texel.x, texel.y + int(moon.paneRows) - size) + 0.5) / vec2(moon.surfelColumns, moon.paneRows);
    surfel.position = moon.paneCorner + moon.paneAcross * place.x + moon.paneUp * place.y;
    surfel.normal = moon.paneNormal;
    surfel.area = moon.paneArea / (moon.surfelColumns * moon.paneRows);
    surfel.distance = moon.paneArea;
  }
  return surfel;
}
#else
Surfel surfelAt(ivec2 texel, int size) {
  vec4 normalDistance = texelFetch(uSurfelNormalDistance, texel, 0);
  int face = texel.x / size;
  vec2 st = (vec2(texel.x - face * size, texel.y) + 0.5) / float(size) * 2.0 - 1.0;
  vec3 direction = faceDirection(face, st);
  float squared = dot(direction, direction);
  // Of a texel of a cube of half-edge 1, from its centre.
  float solidAngle = 4.0 / float(size * size) / (squared * sqrt(squared));
  direction *= inversesqrt(squared);
  Surfel surfel;
  surfel.position = light.captureOrigin + direction * normalDistance.w;
  surfel.normal = normalDistance.xyz;
  surfel.area = solidAngle * normalDistance.w * normalDistance.w / limitedCosine(dot(normalDistance.xyz, -direction));
  surfel.solidAngle = solidAngle;
  surfel.distance = normalDistance.w;
  return surfel;
}
#endif
