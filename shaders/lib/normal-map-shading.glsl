// Normal-map shading: the normal map's share of N.L and the occlusion, folded into the albedo of the G-buffer,
// so that lighting at a lower rate need not know of them.
// Needs lib/gbuffer.glsl.

// Direct share of a surface's light, which the normal map affects. Fitted to a path tracer's views of the cabin and of
// plain rooms, by the errors that tests/visual/reference.spec.ts and rooms.spec.ts print.
const float DIRECT_SHARE = 0.75;
// Least cosine: grazing light would turn the normal map into noise.
const float LEAST_COSINE = 0.25;

// Ratio of N.L with the normal map to N.L without: 1 where the map is flat, and on the side without direct light.
float normalMapShading(float surfaceNoL, float mappedNoL) {
  float lit = clamp(1.0 + surfaceNoL / LEAST_COSINE, 0.0, 1.0);
  return clamp(1.0 + lit * (mappedNoL - surfaceNoL) / max(surfaceNoL, LEAST_COSINE), 0.0, 1.6);
}

// Factor on the albedo.
float shadedAlbedoScale(float occlusion, float shading) {
  return mix(occlusion, shading, DIRECT_SHARE) / ALBEDO_SCALE;
}
