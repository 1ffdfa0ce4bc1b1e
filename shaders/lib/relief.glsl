// Self-occlusion of the relief that a normal map represents.
// Needs lib/normal-map.glsl.

// Visibility of a light past the relief, whose slope is that of `normal` against the surface.
// Conty Estevez, Lecocq and Stein 2019, "A Microfacet-Based Shadowing Function to Solve the Bump Terminator Problem",
// smoothed by the cubic of Cycles.
float normalMapVisibility(vec3 surface, vec3 normal, vec3 toLight) {
  float share = dot(surface, toLight) / max(dot(normal, toLight) * dot(surface, normal), 1e-4);
  share = clamp(share, 0.0, 1.0);
  return share * (1.0 + share - share * share);
}

// Its mean over the hemisphere, fitted to a hundredth up to 60 degrees.
float skyVisibility(vec3 surface, vec3 normal) {
  float facing = clamp(dot(surface, normal), 0.0, 1.0);
  float sine = sqrt(1.0 - facing * facing);
  return 1.0 - sine * (0.24 + 0.18 * sine);
}

// Mean sky visibility over a sixteenth of a normal map's width and height, from its finest level: coarser levels are
// too flat.
float meanSkyVisibility(sampler2D normalMap, vec2 uv, float scale) {
  const vec3 FLAT = vec3(0.0, 0.0, 1.0);
  float sum = 0.0;
  for (int i = 0; i < 16; i++) {
    vec2 tap = uv + (vec2(i & 3, i >> 2) - 1.5) / 64.0;
    sum += skyVisibility(FLAT, tangentNormal(textureLod(normalMap, tap, 0.0).xy, scale));
  }
  return sum / 16.0;
}
