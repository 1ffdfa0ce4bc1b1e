// Composite: albedo x lighting x intensity.
// Needs lib/flame-light.glsl, lib/gbuffer.glsl, and lib/upsample-guided.glsl or lib/upsample-bilateral.glsl.

// Radiance, cd/m². `albedo`: of the G-buffer, gamma 2.
vec3 compositeRadiance(vec4 albedo, vec2 uv) {
  vec4 lighting = texture(uLighting, lightingUv(uv, albedo));
  vec3 diffuse = albedo.rgb * lighting.rgb;
  return (ALBEDO_SCALE * diffuse * diffuse + lighting.a * lighting.a) * light.intensity;
}
