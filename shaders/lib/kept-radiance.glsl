// Radiance of a pixel that keeps what an earlier frame had. Its alpha is below 0, and holds luminance for each lux and,
// in the last two bits of its half float, the pixel's age: frames since it was shaded, 1 to 3.

// Added to luminance: GPUs may flush half floats nearer to 0, as they may infinite ones.
const float KEPT_OFFSET = 1.0 / 8192.0;

vec4 keptRadiance(vec4 radiance, int age) {
  uint bits = (packHalf2x16(vec2(radiance.a + KEPT_OFFSET, 0.0)) & 0xfffcu) | uint(age);
  return vec4(radiance.rgb, -unpackHalf2x16(bits).x);
}

// Frames since a pixel was shaded. `alpha`: of its radiance.
int ageOf(float alpha) {
  return alpha < 0.0 ? int(packHalf2x16(vec2(-alpha, 0.0)) & 3u) : 0;
}

// Luminance for each lux. `alpha`: of radiance that may be kept.
float luminancePerLux(float alpha) {
  return alpha < 0.0 ? max(-alpha - KEPT_OFFSET, 0.0) : alpha;
}
