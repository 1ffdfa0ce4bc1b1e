// At which sample of the surfaces a texel of the light is worked out.
// Needs lib/gbuffer.glsl.

uniform sampler2D uRepresentative;  // opaque/representative-sample.frag

ivec2 representativeSample(ivec2 texel, vec2 lightSize, ivec2 samples) {
  int usual = int(texelFetch(uRepresentative, texel, 0).r * 255.0 + 0.5);
  return clamp(pixelOfTexel(texel, lightSize, vec2(samples)) + aside(usual), ivec2(0), samples - 1);
}
