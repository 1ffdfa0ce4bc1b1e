// Luminance of a surface of forward shading in direct moonlight, for 1 lx.
// Needs lib/brdf.glsl, lib/relief.glsl, lib/surface.glsl, lib/moon-shadow.glsl.

// Visible share of the moon; 0 where the surface faces away from it, or beside its beam. `shadows`: 1 or 0. `pixel`: seed
// of the shadow's taps.
float visibilityOfMoon(vec3 surface, vec3 facet, float shadows, vec2 pixel) {
  bool isInside = dot(surface, moon.direction) < 0.0 && isInBeam(vPositionWorld);
  float visibility = 0.0;
  // A software renderer runs both sides of an if, but leaves a loop that no pixel is in.
  for (int i = isInside ? 1 : 0; i > 0; i--) {
    vec3 toward = faceforward(facet, moon.direction, facet);
    visibility = mix(1.0, moonVisibility(vPositionWorld, toward, pixel, 0.0), shadows);
  }
  return visibility;
}

// `visibility`: of the moon. `mirrors`: 1 or 0.
float directMoonlight(Shading s, float visibility, vec3 diffuseColor, float mirrors) {
  vec3 L = -moon.direction;
  float NoL = dot(s.normal, L);
  float sum = 0.0;
  for (int i = min(visibility, NoL) > 0.0 ? 1 : 0; i > 0; i--) {
    float lit = NoL * visibility;
    vec3 H = normalize(L + s.view);
    float widened = widenedAlpha(s.alpha, MOON_TANGENT);
    float lobe = distributionGgx(widened, max(dot(s.normal, H), 0.0)) * visibilitySmith(s.alpha, s.NoV, NoL);
    float specular = moonLuma(fresnelSchlick(s.f0, max(dot(L, H), 0.0))) * lobe * mirrors;
    sum = lit * (moonLuma(diffuseColor) / PI * normalMapVisibility(s.surface, s.normal, L) * s.minified.y + specular);
  }
  return sum;
}
