// At which sample of the surfaces a texel of the light is worked out.
// Needs lib/gbuffer.glsl.

uniform sampler2D uUsual;  // opaque/representative-sample.frag

ivec2 sampleOf(ivec2 texel, vec2 lightSize, ivec2 samples) {
  int usual = int(texelFetch(uUsual, texel, 0).r * 255.0 + 0.5);
  return clamp(pixelOf(texel, lightSize, vec2(samples)) + aside(usual), ivec2(0), samples - 1);
}
