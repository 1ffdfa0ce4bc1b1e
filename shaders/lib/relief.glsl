// The normal that a normal map gives a surface.

// glTF's bitangent: cross(normal, tangent) with the sign in tangent.w. The columns of
// worldFromTangent are tangent, bitangent, normal, so it takes tangent space to the world; the
// published code multiplied a world vector by it, which is the inverse of what it meant.
vec3 reliefNormal(sampler2D normalMap, vec2 uv, vec3 normal, vec4 tangent) {
  vec3 n = normalize(normal);
  vec3 t = normalize(tangent.xyz - n * dot(n, tangent.xyz));
  mat3 worldFromTangent = mat3(t, cross(n, t) * tangent.w, n);
  vec2 slope = texture(normalMap, uv).xy * 2.0 - 1.0;
  // Two channels are stored; the third follows, since the vector has length 1.
  return worldFromTangent * vec3(slope, sqrt(max(1.0 - dot(slope, slope), 0.0)));
}

// The plane of the triangle itself.
vec3 facetNormal(vec3 positionWorld) {
  return normalize(cross(dFdx(positionWorld), dFdy(positionWorld)));
}
