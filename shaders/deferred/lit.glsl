// The light of a pixel: its paint times the light around it.
// Needs physical/light.glsl, deferred/stored.glsl.

uniform sampler2D uPainted;
uniform sampler2D uLight;

// Where to read the light for a place in the picture, given what the guide says of it.
vec2 guided(vec2 uv, float stored) {
  float code = stored * 255.0 - 0.5;
  if (code < 0.0) return uv;
  vec2 size = vec2(textureSize(uLight, 0));
  float row = floor(code / (PLACES + 1.0));
  vec2 place = vec2(floor(code) - row * (PLACES + 1.0), row) * (1.0 / PLACES);
  return (floor(uv * size - 0.5) + 0.5 + place) / size;
}

// cd/m².
vec3 litFrom(vec4 painted, vec2 uv) {
  vec4 lit = textureLod(uLight, guided(uv, painted.a), 0.0);
  return (BRIGHTEST * painted.rgb * painted.rgb * lit.rgb + lit.a) * light.intensity;
}

vec3 litAt(vec2 uv) {
  return litFrom(texelFetch(uPainted, ivec2(gl_FragCoord.xy), 0), uv);
}
