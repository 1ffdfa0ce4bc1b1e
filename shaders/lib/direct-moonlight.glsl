// Luminance of a surface of forward shading in direct moonlight, for 1 lx.
// Needs lib/brdf.glsl, lib/relief.glsl, lib/surface.glsl, lib/moon-shadow.glsl.

// `seen`: 1 or 0: shadows, specular. `pixel`: seed of the shadow's taps.
float directMoonlight(Shading s, vec3 facet, vec3 diffuseColor, vec2 seen, vec2 pixel) {
  vec3 L = -moon.direction;
  float NoL = dot(s.normal, L);
  bool isInside = NoL > 0.0 && isInBeam(vPositionWorld);
  float sum = 0.0;
  // A software renderer runs both sides of an if, but leaves a loop that no pixel is in.
  for (int i = isInside ? 1 : 0; i > 0; i--) {
    float visibility = moonVisibility(vPositionWorld, faceforward(facet, moon.direction, facet), pixel, 0.0);
    float lit = NoL * mix(1.0, visibility, seen.x);
    vec3 H = normalize(L + s.view);
    float widened = widenedAlpha(s.alpha, MOON_TANGENT);
    float lobe = distributionGgx(widened, max(dot(s.normal, H), 0.0)) * visibilitySmith(s.alpha, s.NoV, NoL);
    float specular = moonLuma(fresnelSchlick(s.f0, max(dot(L, H), 0.0))) * lobe * seen.y;
    sum = lit * (moonLuma(diffuseColor) / PI * normalMapVisibility(s.surface, s.normal, L) * s.minified.y + specular);
  }
  return sum;
}
