// The flame as a lamp: an upright capsule, equally intense from all sides.

layout(std140) uniform Light {
  vec3 position;     // centre of the light, m
  float halfHeight;  // m
  vec3 intensity;    // cd
  float radius;      // m
} light;
