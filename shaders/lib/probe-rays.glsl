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

// Weight of the rays against the surfels, by the solid angles of both from the probe, sr.
float rayWeight(float surfelSolidAngle, float raySolidAngle) {
  return surfelSolidAngle / (surfelSolidAngle + raySolidAngle);
}
