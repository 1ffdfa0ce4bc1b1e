// Photometry, in SI units. Colours are linear Rec. 709, scaled so that the luma of radiance is luminance in cd/m², of
// irradiance illuminance in lx, of intensity candela.

const float PI = 3.14159265;

float luma(vec3 color) {
  return dot(color, vec3(0.2126729, 0.7151522, 0.0721750));
}

// Specular albedo of wood or stone, mean over the hemisphere: src/render/opaque/environment-brdf.ts at roughness 0.65.
const float SPECULAR_ALBEDO = 0.04;

// Reflectance for light from all around, its colourless specular part included.
vec3 hemisphericalReflectance(vec3 baseColor) {
  return mix(baseColor, vec3(1.0), SPECULAR_ALBEDO);
}
