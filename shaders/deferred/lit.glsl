// The light of a pixel: its paint times the light around it.
// Needs physical/light.glsl, deferred/stored.glsl, and deferred/told.glsl or deferred/guessed.glsl.

uniform sampler2D uPainted;

// cd/m².
vec3 litFrom(vec4 painted, vec2 uv) {
  vec4 lit = textureLod(uLight, guided(uv, painted.a), 0.0);
  return (BRIGHTEST * painted.rgb * painted.rgb * lit.rgb + lit.a) * light.intensity;
}

vec3 litAt(vec2 uv) {
  return litFrom(textureLod(uPainted, uv, 0.0), uv);
}
