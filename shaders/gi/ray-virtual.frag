#version 300 es
// Second bounce of the moon's light and the sky's at the hits of the probes' rays: that of the virtual lights, reflected.
// Out: radiance times solid angle of four rays side by side, cd/m² sr.
#include "lib/precision.glsl"
#include "lib/photometry.glsl"
#include "lib/moon.glsl"
#include "lib/virtual-lights.glsl"
#include "lib/probe-rays.glsl"

uniform sampler2D uProbePositions;  // m
uniform sampler2D uRayReflectance;

out vec4 oRadiance;

vec3 irradianceAt(vec3 position, vec3 normal) {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < VIRTUAL_LIGHTS; i++) {
    VirtualLight v = virtualLightAt(i, position);
    float NoL = dot(normal, v.L);
    if (min(v.facing, NoL) <= 0.0) continue;
    sum += virtualIrradiance(v, i, NoL) * virtualVisibility(v.d, normal, float(i));
  }
  return sum;
}

void main() {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 4; i++) {
    ProbeRay ray = probeRayAt(2 * ivec2(gl_FragCoord.xy) + ivec2(i & 1, i >> 1));
    if (ray.reach <= 0.0) continue;
    vec3 position = texelFetch(uProbePositions, ray.tile, 0).xyz + ray.direction * ray.reach;
    vec3 reflectance = texelFetch(uRayReflectance, ray.texel, 0).rgb;
    sum += reflectance * irradianceAt(position, ray.normal) * (ray.solidAngle / PI);
  }
  oRadiance = vec4(sum, 1.0);
}
