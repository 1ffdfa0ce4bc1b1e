// Deferred lighting for a moon of 1 lx, and the night behind panes. It is colourless.
// Needs lib/brdf.glsl, lib/moon.glsl, lib/moon-shadow.glsl, lib/night-sky.glsl, lib/gbuffer.glsl, lib/lighting-texel.glsl.

uniform sampler2D uGBufferAlbedo;

// Footprint at most: neighbours may be of surfaces far apart, m.
const float WIDEST = 0.04;

// Direct moonlight: factor of the albedo, and the part without albedo, cd/m². `seen`: 1 or 0, shadows and specular.
vec2 moonLighting(LightingTexel texel, vec3 toEye, float NoV, vec2 seen) {
  vec3 normal = texel.normal;
  vec3 L = -moon.direction;
  float NoL = max(dot(normal, L), 0.0);
  vec2 tile = mod(floor(gl_FragCoord.xy), 2.0);
  float footprint = max(length(dFdx(texel.position)), length(dFdy(texel.position)));
  float visibility = NoL > 0.0 ? moonVisibility(texel.position, normal, tile, min(footprint, WIDEST)) : 0.0;
  float perArea = NoL * mix(1.0, visibility, seen.x);
  float metallic = metallicOf(texel.material);
  float alpha = texel.roughness * texel.roughness;
  // The disc's width widens the lobe.
  float widened = clamp(alpha + 0.5 * MOON_TANGENT, 0.0, 1.0);
  vec3 H = normalize(L + toEye);
  float fresnel = fresnelSchlick(vec3(0.04), max(dot(L, H), 0.0)).r;
  float specular = distributionGgx(widened, max(dot(normal, H), 0.0)) * visibilitySmith(alpha, NoV, NoL);
  specular *= alpha * alpha / (widened * widened) * perArea * seen.y;
  float factor = (1.0 - metallic) * (1.0 - fresnel) / PI * perArea + metallic * specular;
  return vec2(factor, (1.0 - metallic) * fresnel * specular);
}

// The night behind a pane as a factor of the albedo: the part without albedo has the flame's colour while that burns.
float nightLighting(LightingTexel texel, vec3 toEye, float NoV) {
  bool isPane = isGlass(texel.material) && isOnPane(texel.position);
  float factor = 0.0;
  // A software renderer executes both sides of an `if`, but skips a loop that no pixel enters.
  for (int i = isPane ? 1 : 0; i > 0; i--) {
    vec4 albedo = texture(uGBufferAlbedo, texel.onScreen);
    factor = nightThroughPane(-toEye, NoV) / max(ALBEDO_SCALE * albedo.g * albedo.g, 1e-3);
  }
  return factor;
}
