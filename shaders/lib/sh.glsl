// Spherical harmonics of degree 2. Needs lib/photometry.glsl.
//
// The nine coefficients of a probe lie in SH_TEXELS texels side by side of three textures: texel k holds
// coefficients k, k + 3 and k + 6.

const int SH_TEXELS = 3;

struct ShTexel {
  vec3 first;   // coefficient k
  vec3 second;  // k + 3
  vec3 third;   // k + 6
};

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

// Projects radiance from a direction onto the coefficients of texel k.
void addRadiance(inout ShTexel sum, int k, vec3 direction, vec3 radiance) {
  sum.first += shBasis(k, direction) * radiance;
  sum.second += shBasis(k + 3, direction) * radiance;
  sum.third += shBasis(k + 6, direction) * radiance;
}

// Coefficient of the cosine lobe that turns radiance into irradiance.
// Ramamoorthi and Hanrahan 2001, "An Efficient Representation for Irradiance Environment Maps".
float cosineLobe(int k) {
  return k == 0 ? PI : k < 4 ? 2.0 * PI / 3.0 : PI / 4.0;
}
