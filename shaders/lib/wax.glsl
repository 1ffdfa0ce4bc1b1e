// Light that entered the wax at its top and comes out of its side, as if it faded evenly with depth.
// Needs lib/photometry.glsl, lib/flame-light.glsl.

// In a rod as thin as a taper more of it is lost through the side than in the wax itself: 14, 10.5 and
// 7 mm in the thick of paraffin become these, m.
const vec3 DIFFUSION_LENGTH = vec3(0.0092, 0.0078, 0.0056);
// Share of the light on the top that finds its way out below it.
const float WAX_TRANSMITTANCE = 0.02;
// The flame is this far above the top at least, m.
const float NEAREST_TOP = 0.01;

// Radiance for an albedo of 1, cd/m².
vec3 waxGlow(vec3 position) {
  float depth = max(light.rim - position.y, 0.0);
  float above = max(light.position.y - light.rim, NEAREST_TOP);
  vec3 onTop = light.intensity / (above * above + 1e-4);
  return onTop * exp(-depth / DIFFUSION_LENGTH) * (WAX_TRANSMITTANCE / PI);
}
