// Radiance of a pixel that keeps what the previous frame had, marked by its alpha: below 0, and a normal half float,
// since GPUs may flush others to 0. Luminance for each lux is its magnitude.

vec4 keptRadiance(vec4 radiance) {
  return vec4(radiance.rgb, -max(radiance.a, 6.2e-5));
}
