// Where a pixel is to take its light from, as opaque/upsample-guide.frag has found out.
// Needs lib/gbuffer.glsl.

uniform sampler2D uGBufferAlbedo;
uniform sampler2D uLight;

vec2 lightingUv(vec2 uv, vec4 painted) {
  float code = painted.a * 255.0 - 0.5;
  if (code < 0.0) return uv;
  vec2 size = vec2(textureSize(uLight, 0));
  float row = floor(code / (GUIDE_STEPS + 1.0));
  vec2 place = vec2(floor(code) - row * (GUIDE_STEPS + 1.0), row) * (1.0 / GUIDE_STEPS);
  return (floor(uv * size - 0.5) + 0.5 + place) / size;
}
