#version 300 es
// A surface in light of 1 cd/m² from all around: by the cosine of the eye's angle along x, roughness along y.
// Out: radiance of a perfect mirror; of a white one under a clear layer; of what the first mirrors at all.
#include "lib/precision.glsl"
#include "lib/brdf.glsl"
#include "lib/environment-brdf.glsl"

uniform sampler2D uEnvironmentBrdf;

in vec2 vUv;

out vec4 oRadiance;

const int RINGS = 128;
const int SPOKES = 64;

void main() {
  float NoV = vUv.x;
  float roughness = 0.3 + 0.7 * vUv.y;
  float alpha = roughness * roughness;
  vec3 view = vec3(sqrt(1.0 - NoV * NoV), 0.0, NoV);
  vec2 mirror = vec2(0.0);
  for (int ring = 0; ring < RINGS; ring++) {
    for (int spoke = 0; spoke < SPOKES; spoke++) {
      // Closer together where light grazes, and beside the mirrored ray.
      vec2 st = (vec2(ring, spoke) + 0.5) / vec2(RINGS, SPOKES);
      float NoL = st.x * st.x;
      float angle = PI * st.y * st.y;
      vec3 L = vec3(sqrt(1.0 - NoL * NoL) * vec2(-cos(angle), sin(angle)), NoL);
      vec3 H = normalize(L + view);
      float lobe = distributionGgx(alpha, H.z) * visibilitySmith(alpha, NoV, NoL) * NoL;
      float fresnel = fresnelSchlick(vec3(0.04), max(dot(L, H), 0.0)).r;
      mirror += lobe * vec2(1.0, fresnel) * (8.0 * PI * st.x * st.y / float(RINGS * SPOKES));
    }
  }
  float metal = mirror.x * environmentReflection(uEnvironmentBrdf, vec3(1.0), roughness, NoV).boost.r;
  EnvironmentReflection clear = environmentReflection(uEnvironmentBrdf, vec3(0.04), roughness, NoV);
  oRadiance = vec4(metal, mirror.y * clear.boost.r + 1.0 - clear.share.r, mirror.x, 1.0);
}
