// Hits of the probes' rays: an octahedral map for each probe, in tiles.
//
// The first bounce is sampled twice: by surfels, which are fine near the flame, and by rays, which are fine near the
// probe. They are combined by the balance heuristic (Veach and Guibas 1995, "Optimally Combining Sampling Techniques
// for Monte Carlo Rendering").
#include "lib/octahedral.glsl"
#include "lib/photometry.glsl"

uniform int uRays;        // texels along an edge of a map
uniform int uProbeRows;   // rows of tiles in a plane of probes
uniform int uGroup;       // surfels along an edge of those that are taken as one
uniform int uSurfelRows;  // rows of such groups for each probe
uniform sampler2D uRayHits;  // normal on the ray's side; distance, m, 0 for a miss or a back face

// a / b, for the integers of texels: faster than GLSL's.
ivec2 quotient(ivec2 a, ivec2 b) {
  return ivec2((vec2(a) + 0.5) / vec2(b));
}

// Turn of a probe's rays about (1, 1, 1): other directions for each of the eight probes around a point, so that their
// errors differ and interpolation averages them. First row of a matrix whose next rows are the same, moved on.
// `rayDirections` of src/render/gi/ray-directions.ts.
vec3 turnOf(ivec2 tile) {
  int plane = quotient(ivec2(tile.y), ivec2(uProbeRows)).x;
  int corner = (tile.x & 1) + 2 * ((tile.y - plane * uProbeRows) & 1) + 4 * (plane & 1);
  float angle = float(corner) * (2.0 * PI / 24.0);
  float rest = (1.0 - cos(angle)) / 3.0;
  float sine = sin(angle) / sqrt(3.0);
  return vec3(1.0 - 2.0 * rest, rest - sine, rest + sine);
}

vec3 turned(vec3 v, vec3 turn) {
  return vec3(dot(v, turn), dot(v, turn.zxy), dot(v, turn.yzx));
}

vec3 turnedBack(vec3 v, vec3 turn) {
  return turned(v, turn.xzy);
}

// Solid angle of the texel around a point of the octahedron, sr.
float raySolidAngle(vec3 onOctahedron) {
  float radius = length(onOctahedron);
  return 4.0 / float(uRays * uRays) / (radius * radius * radius);
}

struct ProbeRay {
  ivec2 tile;   // of the probe
  ivec2 texel;
  vec3 direction;
  float solidAngle;  // sr
  vec3 normal;  // at the hit
  float reach;  // m, 0 for a miss or a back face
};

ProbeRay probeRayAt(ivec2 texel) {
  ProbeRay ray;
  ray.texel = texel;
  ray.tile = quotient(texel, ivec2(uRays));
  vec3 onOctahedron = octahedralDecode((vec2(texel - ray.tile * uRays) + 0.5) / float(uRays));
  ray.direction = turned(normalize(onOctahedron), turnOf(ray.tile));
  ray.solidAngle = raySolidAngle(onOctahedron);
  vec4 hit = texelFetch(uRayHits, texel, 0);
  ray.normal = hit.xyz;
  ray.reach = hit.w;
  return ray;
}

// The volume is sampled this far in front of a surface, m.
const float HIT_OFFSET = 0.03;

// Point at which a hit samples the volume, m.
vec3 hitPosition(ProbeRay ray, vec3 probe) {
  return probe + ray.direction * ray.reach + ray.normal * HIT_OFFSET;
}

// Weight of the rays against the surfels, by the solid angles of both from the probe, sr.
float rayWeight(float surfelSolidAngle, float raySolidAngle) {
  return surfelSolidAngle / (surfelSolidAngle + raySolidAngle);
}
