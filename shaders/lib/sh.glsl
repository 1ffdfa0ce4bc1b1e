// Spherical harmonics of degree 2. Needs lib/photometry.glsl.

const int SH_COUNT = 9;

// Green 2003, "Spherical Harmonic Lighting: The Gritty Details".
float shBasis(int k, vec3 d) {
  if (k == 0) return 0.282095;
  if (k == 1) return 0.488603 * d.x;
  if (k == 2) return 0.488603 * d.y;
  if (k == 3) return 0.488603 * d.z;
  if (k == 4) return 1.092548 * d.x * d.y;
  if (k == 5) return 1.092548 * d.y * d.z;
  if (k == 6) return 1.092548 * d.x * d.z;
  if (k == 7) return 0.315392 * (3.0 * d.y * d.y - 1.0);
  return 0.546274 * (d.x * d.x - d.z * d.z);
}

// Ramamoorthi and Hanrahan 2001, "An Efficient Representation for Irradiance Environment Maps": what a
// cosine lobe keeps of each.
float kept(int k) {
  return k == 0 ? PI : k < 4 ? 2.0 * PI / 3.0 : PI / 4.0;
}

// Each probe has its coefficients in three texels side by side of three textures: texel k % 3 of texture
// k / 3.
const int TILE = 3;
