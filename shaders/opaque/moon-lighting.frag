#version 300 es
// Deferred lighting for a moon of 1 lx, and the night behind panes, at the rate of the flame's, at rest.
// In:  G-buffer, the moon's map, its irradiance volume.
// Out: square roots of the albedo's factor, cd/m², and of what is added to it. The moon's light is colourless here.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/loop-count.glsl"
#include "lib/octahedral.glsl"
#include "lib/random.glsl"
#include "lib/depth.glsl"
#include "lib/brdf.glsl"
#include "lib/dielectric.glsl"
#include "lib/moon.glsl"
#include "lib/moon-shadow.glsl"
#include "lib/night-sky.glsl"
#define VOLUME_CORNERS COUNT(8)
#include "lib/irradiance-volume.glsl"
#include "lib/gbuffer.glsl"
#include "lib/representative-sample.glsl"
#include "lib/lighting-texel.glsl"
#include "lib/moon-lighting.glsl"

uniform vec3 uFeatures;  // 1 or 0: shadows, indirect light, specular

out vec4 oLighting;

void main() {
  LightingTexel texel = lightingTexel();
  vec3 normal = texel.normal;
  float metallic = metallicOf(texel.material);
  vec3 toEye = normalize(frame.eyePosition - texel.position);
  float NoV = max(abs(dot(normal, toEye)), 1e-3);
  vec2 direct = moonLighting(texel, toEye, NoV, uFeatures.xz);

  vec3 reflected = reflect(-toEye, normal);
  IrradianceSample indirect = irradianceAt(texel.position + normal * 0.08, normal, normal, reflected);
  float mirrored = dielectricShare(texel.roughness, NoV);
  vec3 perLux = direct.x + indirect.alongNormal * ((1.0 - metallic) * (1.0 - mirrored) / PI * uFeatures.y);
  vec3 room = indirect.alongReflection / PI * ((1.0 - 0.6 * texel.roughness) * uFeatures.y * uFeatures.z);
  perLux += metallic * room + nightLighting(texel, toEye, NoV);
  float added = direct.y + (1.0 - metallic) * mirrored * luma(room);
  oLighting = sqrt(clamp(vec4(perLux, added), 0.0, 3e4));
}
