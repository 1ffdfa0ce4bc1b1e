// The paper's point light: a colour without a unit, and an attenuation that reaches the whole room.

layout(std140) uniform Light {
  vec3 position;     // m
  float attenuates;  // 1 or 0
  vec3 color;        // linear Rec. 709
} light;

// Phong's lobe, of exponent 16.
float highlight(float cosine) {
  float power = max(cosine, 0.0);
  power *= power;
  power *= power;
  power *= power;
  return power * power;
}

float attenuation(float distance) {
  return light.attenuates > 0.5
    ? 1.0 / (1.0 + 0.09 * distance + 0.032 * distance * distance)
    : 1.0;
}
