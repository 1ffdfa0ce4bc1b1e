// Hits of the probes' rays: an octahedral map for each probe, RAYS texels along an edge, in tiles.
// Needs lib/octahedral.glsl.
//
// The first bounce is sampled twice: by surfels, which are fine near the flame, and by rays, which are fine near the
// probe. They are combined by the balance heuristic (Veach and Guibas 1995, "Optimally Combining Sampling Techniques
// for Monte Carlo Rendering").

uniform sampler2D uRayHits;  // normal on the ray's side; distance, m, 0 for a miss or a back face

// Solid angle of the texel around a point of the octahedron, sr.
float raySolidAngle(vec3 onOctahedron) {
  float radius = length(onOctahedron);
  return 4.0 / float(RAYS * RAYS) / (radius * radius * radius);
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
  ray.tile = texel / RAYS;
  vec3 onOctahedron = octahedralDecode((vec2(texel - ray.tile * RAYS) + 0.5) / float(RAYS));
  ray.direction = normalize(onOctahedron);
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
