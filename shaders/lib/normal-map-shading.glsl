// The part that relief and crevices have in how bright a surface is painted.
// Needs lib/gbuffer.glsl.

// Share of a surface's light that comes straight from the flame, and so shows its relief.
const float STRAIGHT = 0.65;
// Grazing light would turn relief to noise.
const float LEAST_FACING = 0.25;

// How much of the flame's light relief catches, where a plain surface would catch 1. Both cosines are of
// the angle to the flame: the surface's and the relief's.
float normalMapShading(float surface, float relief, float scale) {
  float turned = max(surface + (relief - surface) * scale, 0.0);
  return min(turned / max(surface, LEAST_FACING) + max(LEAST_FACING - surface, 0.0), 1.6);
}

// How bright a surface is painted, as a share of its albedo over ALBEDO_SCALE.
float shadedAlbedoScale(float occlusion, float caught) {
  return mix(occlusion, caught, STRAIGHT) / ALBEDO_SCALE;
}
