// Upsampling of the lighting by the guide that opaque/upsample-guide.frag has written.
// Needs lib/gbuffer.glsl.

uniform sampler2D uGBufferAlbedo;
uniform sampler2D uLighting;

// Where a pixel reads its lighting. `albedo`: its texel of the G-buffer, the guide in alpha.
vec2 lightingUv(vec2 uv, vec4 albedo) {
  float code = albedo.a * 255.0 - 0.5;
  if (code < 0.0) return uv;
  vec2 size = vec2(textureSize(uLighting, 0));
  float row = floor(code / (GUIDE_STEPS + 1.0));
  vec2 offset = vec2(floor(code) - row * (GUIDE_STEPS + 1.0), row) * (1.0 / GUIDE_STEPS);
  return (floor(uv * size - 0.5) + 0.5 + offset) / size;
}
