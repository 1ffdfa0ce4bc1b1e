// Composite: albedo x lighting x intensity. REDUCED: of a G-buffer of fewer pixels; REPROJECTED: of the previous frame's.
// Needs lib/flame-light.glsl.
#include "lib/gbuffer.glsl"
#if REDUCED
#include "lib/depth.glsl"
#if REPROJECTED
#include "lib/reproject.glsl"
#endif
#include "lib/upsample-bilateral.glsl"
#else
#include "lib/upsample-guided.glsl"
#endif

// Radiance, cd/m². `albedo`: of the G-buffer, gamma 2.
vec3 compositeRadiance(vec4 albedo, vec2 uv) {
  vec4 lighting = texture(uLighting, lightingUv(uv, albedo));
  vec3 diffuse = albedo.rgb * lighting.rgb;
  return (ALBEDO_SCALE * diffuse * diffuse + lighting.a * lighting.a) * light.intensity;
}
