// Normal mapping.

// Normal of a texel, of which two channels are stored: the third follows from the length of 1. glTF scales the two.
vec3 tangentNormal(vec2 texel, float scale) {
  vec2 slope = texel * 2.0 - 1.0;
  return normalize(vec3(scale * slope, sqrt(max(1.0 - dot(slope, slope), 1e-4))));
}

// Of length 1. What vertices interpolate is zero where theirs are opposed, and no number once divided by its length.
vec3 directionOf(vec3 interpolated) {
  return normalize(interpolated + vec3(0.0, 1e-12, 0.0));
}

// World normal of a texel, on the side of `normal`, which is the visible one: from behind, bumps are dents. Bitangent as
// in glTF: cross(normal, tangent), with the sign in tangent.w. The paper's code applies the inverse of worldFromTangent.
vec3 perturbedNormal(vec2 texel, vec3 normal, vec4 tangent, float scale) {
  vec3 n = directionOf(normal);
  vec3 t = directionOf(tangent.xyz - n * dot(n, tangent.xyz));
  return mat3(gl_FrontFacing ? t : -t, cross(n, t) * tangent.w, n) * tangentNormal(texel, scale);
}

// Normal of the triangle, from screen-space derivatives.
vec3 facetNormal(vec3 positionWorld) {
  return normalize(cross(dFdx(positionWorld), dFdy(positionWorld)));
}
