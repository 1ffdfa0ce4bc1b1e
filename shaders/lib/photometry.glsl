// Photometry, in SI units. Colours are linear Rec. 709, scaled so that the luma of radiance is luminance in cd/m², of
// irradiance illuminance in lx, of intensity candela.

const float PI = 3.14159265;

float luma(vec3 color) {
  return dot(color, vec3(0.2126729, 0.7151522, 0.0721750));
}
