// The G-buffer sample that represents a lighting texel, as opaque/representative-sample.frag has chosen it.
// Needs lib/gbuffer.glsl.

uniform sampler2D uRepresentative;

ivec2 representativeSample(ivec2 texel, vec2 lightingSize, ivec2 samples) {
  int candidate = int(texelFetch(uRepresentative, texel, 0).r * 255.0 + 0.5);
  ivec2 center = sampleAtTexel(texel, lightingSize, vec2(samples));
  return clamp(center + candidateOffset(candidate), ivec2(0), samples - 1);
}
