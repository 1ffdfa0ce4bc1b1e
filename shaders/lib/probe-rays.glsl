// What probes' rays meet: an octahedral map for each probe, RAYS texels along an edge, in tiles.
// Needs lib/octahedral.glsl.
//
// Light that bounces for the first time is gathered twice over: patches that the flame sees are fine near
// the flame, what the rays meet is fine near the probe. Each counts by how well it samples a place.
// Veach and Guibas 1995, "Optimally Combining Sampling Techniques for Monte Carlo Rendering": the balance heuristic.

uniform sampler2D uRayHits;  // normal on the ray's side; distance, m, 0 where nothing sends light

// Solid angle of the texel around a point of the octahedron, sr.
float raySolidAngle(vec3 onMap) {
  float away = length(onMap);
  return 4.0 / float(RAYS * RAYS) / (away * away * away);
}

// How much rays count at a place, and patches as much less: by the solid angles that each has there, sr.
float rayWeight(float patchAngle, float raySolidAngle) {
  return patchAngle / (patchAngle + raySolidAngle);
}
