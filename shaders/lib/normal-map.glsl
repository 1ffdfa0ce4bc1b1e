// The normal that a normal map gives a surface.

// The normal that two channels of its texel stand for.
// glTF's bitangent: cross(normal, tangent) with the sign in tangent.w. The columns of
// worldFromTangent are tangent, bitangent, normal, so it takes tangent space to the world; the
// published code multiplied a world vector by it, which is the inverse of what it meant.
vec3 applyNormalMap(vec2 texel, vec3 normal, vec4 tangent) {
  vec3 n = normalize(normal);
  vec3 t = normalize(tangent.xyz - n * dot(n, tangent.xyz));
  mat3 worldFromTangent = mat3(t, cross(n, t) * tangent.w, n);
  vec2 slope = texel * 2.0 - 1.0;
  // Two channels are stored; the third follows, since the vector has length 1.
  return worldFromTangent * vec3(slope, sqrt(max(1.0 - dot(slope, slope), 0.0)));
}

vec3 perturbedNormal(sampler2D normalMap, vec2 uv, vec3 normal, vec4 tangent) {
  return applyNormalMap(texture(normalMap, uv).xy, normal, tangent);
}

// Share of the light from a direction that is not hidden by the relief itself, whose bumps are as steep as
// `normal` is turned from the surface. Conty Estevez, Lecocq and Stein 2019, "A Microfacet-Based Shadowing
// Function to Solve the Bump Terminator Problem", with the cubic that Cycles smooths it by.
float normalMapVisibility(vec3 surface, vec3 normal, vec3 toLight) {
  float share = dot(surface, toLight) / max(dot(normal, toLight) * dot(surface, normal), 1e-4);
  share = clamp(share, 0.0, 1.0);
  return share * (1.0 + share - share * share);
}

// The same of light from all around: its mean over a hemisphere, to a hundredth up to 60 degrees.
float skyVisibility(vec3 surface, vec3 normal) {
  float facing = clamp(dot(surface, normal), 0.0, 1.0);
  float turned = sqrt(1.0 - facing * facing);
  return 1.0 - turned * (0.24 + 0.18 * turned);
}

// Mean of the same over a sixteenth of a normal map's width and height: what is averaged there looks flatter.
float meanSkyVisibility(sampler2D normalMap, vec2 uv, float strength) {
  const vec3 FLAT = vec3(0.0, 0.0, 1.0);
  float sum = 0.0;
  for (int i = 0; i < 16; i++) {
    vec2 place = uv + (vec2(i & 3, i >> 2) - 1.5) / 64.0;
    vec2 slope = textureLod(normalMap, place, 0.0).xy * 2.0 - 1.0;
    vec3 normal = vec3(slope, sqrt(max(1.0 - dot(slope, slope), 0.0)));
    sum += skyVisibility(FLAT, normalize(mix(FLAT, normal, strength)));
  }
  return sum / 16.0;
}

// The plane of the triangle itself.
vec3 facetNormal(vec3 positionWorld) {
  return normalize(cross(dFdx(positionWorld), dFdy(positionWorld)));
}
