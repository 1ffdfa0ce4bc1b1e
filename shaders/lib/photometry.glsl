// Light in SI units. Colours are linear Rec. 709, scaled so that the luma
//   of radiance is luminance in cd/m², of irradiance illuminance in lx, of intensity candela.

const float PI = 3.14159265;

float luma(vec3 color) {
  return dot(color, vec3(0.2126729, 0.7151522, 0.0721750));
}

// What a surface as rough as wood or stone mirrors of light from all around: src/render/opaque/environment-brdf.ts
// at roughness 0.65, averaged over the hemisphere.
const float GLOSS = 0.04;

// Share of light from all around that a surface sends back, its gloss included, which has no colour.
vec3 reflected(vec3 baseColor) {
  return mix(baseColor, vec3(1.0), GLOSS);
}
