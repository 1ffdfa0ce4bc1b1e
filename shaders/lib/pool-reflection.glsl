// The pool of wax below a flame, and the dish of wax that it lies in, as a lamp: they reflect up the light that lies on them.
// Needs lib/flame-light.glsl.

// Intensity straight up, as a share of the flame's: the model's triangles summed, less what wick and lip hide.
const float POOL_REFLECTANCE = 0.16;

// Factor on the flame's light towards a point, by Lambert's law. `toLight`: from there, of any length.
float withPool(vec3 toLight, float lengthSquared) {
  float up = max(-toLight.y, 0.0) * inversesqrt(lengthSquared);
  return light.rimRadius > 0.0 ? 1.0 + POOL_REFLECTANCE * up : 1.0;
}
