// Studio environment of a lone candle.

uniform vec3 uEnvironment; // colour of the environment, luma 1

// Radiance of the environment, cd/m²: lamplight, brightest above and in front.
vec3 environment(vec3 direction) {
  float up = smoothstep(-0.6, 0.9, direction.y);
  float front = pow(max(dot(direction, normalize(vec3(-0.5, 0.5, 0.7))), 0.0), 3.0);
  return uEnvironment * (mix(0.02, 0.06, up) + 0.14 * front);
}
