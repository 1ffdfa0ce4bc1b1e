// Normal mapping.

// World normal of a texel, of which two channels are stored: the third follows from the length of 1.
// Bitangent as in glTF: cross(normal, tangent), with the sign in tangent.w. The paper's code applies the inverse of
// worldFromTangent.
vec3 applyNormalMap(vec2 texel, vec3 normal, vec4 tangent) {
  vec3 n = normalize(normal);
  vec3 t = normalize(tangent.xyz - n * dot(n, tangent.xyz));
  mat3 worldFromTangent = mat3(t, cross(n, t) * tangent.w, n);
  vec2 slope = texel * 2.0 - 1.0;
  return worldFromTangent * vec3(slope, sqrt(max(1.0 - dot(slope, slope), 0.0)));
}

vec3 perturbedNormal(sampler2D normalMap, vec2 uv, vec3 normal, vec4 tangent) {
  return applyNormalMap(texture(normalMap, uv).xy, normal, tangent);
}

// Normal of the triangle, from screen-space derivatives.
vec3 facetNormal(vec3 positionWorld) {
  return normalize(cross(dFdx(positionWorld), dFdy(positionWorld)));
}
