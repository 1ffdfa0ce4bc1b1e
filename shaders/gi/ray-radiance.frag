#version 300 es
// Next bounce at the hits of the probes' rays: the irradiance volume's light, reflected.
// Out: radiance times solid angle of four rays side by side, cd/m² sr.
#include "lib/precision.glsl"
#include "lib/octahedral.glsl"
#include "lib/photometry.glsl"
#include "lib/probe-rays.glsl"
#include "lib/irradiance-volume.glsl"

uniform sampler2D uRayReflectance;
uniform sampler2D uRayProbes;  // two at each hit: gi/ray-probes.frag

out vec4 oRadiance;

void main() {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 4; i++) {
    ProbeRay ray = probeRayAt(2 * ivec2(gl_FragCoord.xy) + ivec2(i & 1, i >> 1));
    if (ray.reach <= 0.0) continue;
    vec4 reflectance = texelFetch(uRayReflectance, ray.texel, 0);
    // A metal mirrors the light of one side.
    vec2 uv = octahedralEncode(mix(ray.normal, reflect(ray.direction, ray.normal), reflectance.a));
    ivec4 tiles = ivec4(texelFetch(uRayProbes, ray.texel, 0) * 255.0 + 0.5);
    vec3 irradiance = 0.5 * (probeIrradiance(tiles.xy, uv) + probeIrradiance(tiles.zw, uv));
    sum += reflectance.rgb * irradiance * (ray.solidAngle / PI);
  }
  oRadiance = vec4(sum, 1.0);
}
