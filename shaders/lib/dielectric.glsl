// Directional albedo of a dielectric's surface. Karis 2014, "Physically Based Shading on Mobile".
float dielectricShare(float roughness, float NoV) {
  vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
  float grazing = min(r.x * r.x, exp2(-9.28 * NoV)) * r.x + r.y;
  return 0.04 * (r.z - 1.04 * grazing) + 1.04 * grazing + r.w;
}
