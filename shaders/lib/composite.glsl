// The light of a pixel: its paint times the light around it.
// Needs lib/flame-light.glsl, lib/gbuffer.glsl, and lib/upsample-guided.glsl or lib/upsample-bilateral.glsl.

// cd/m².
vec3 compositeRadiance(vec4 painted, vec2 uv) {
  vec4 root = texture(uLight, lightingUv(uv, painted));
  vec3 caught = painted.rgb * root.rgb;
  return (ALBEDO_SCALE * caught * caught + root.a * root.a) * light.intensity;
}

vec3 compositeRadianceAt(vec2 uv) {
  return compositeRadiance(texture(uGBufferAlbedo, uv), uv);
}
