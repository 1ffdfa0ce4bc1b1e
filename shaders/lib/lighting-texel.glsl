// What a texel of the deferred lighting lights: a sample of the G-buffer.
// Needs lib/octahedral.glsl, lib/depth.glsl, lib/gbuffer.glsl, and unless REDUCED lib/representative-sample.glsl.

uniform sampler2D uGBufferSurface;
uniform vec2 uLightingSize;
uniform mat4 uWorldFromClip;

struct LightingTexel {
  vec3 position;  // m
  vec3 normal;
  float material;
  float roughness;
  float depth;    // of the depth buffer
  vec2 onScreen;  // uv
};

#if REDUCED
// Of four samples the one whose normal is most similar to all: a texel lit by a joint would be a visible spot.
ivec2 representativePixel(ivec2 pixel) {
  ivec2 upperRight = min(pixel + 1, textureSize(uGBufferSurface, 0) - 1);
  ivec2 right = ivec2(upperRight.x, pixel.y);
  ivec2 upper = ivec2(pixel.x, upperRight.y);
  vec3 a = texelFetch(uGBufferSurface, pixel, 0).rgb - 0.5;
  vec3 b = texelFetch(uGBufferSurface, right, 0).rgb - 0.5;
  vec3 c = texelFetch(uGBufferSurface, upper, 0).rgb - 0.5;
  vec3 d = texelFetch(uGBufferSurface, upperRight, 0).rgb - 0.5;
  vec3 sum = a + b + c + d;
  vec4 similarity = vec4(dot(a, sum), dot(b, sum), dot(c, sum), dot(d, sum));
  vec2 columns = max(similarity.xy, similarity.zw);
  ivec2 inLeft = similarity.x >= similarity.z ? pixel : upper;
  ivec2 inRight = similarity.y >= similarity.w ? right : upperRight;
  return columns.x >= columns.y ? inLeft : inRight;
}
#endif

LightingTexel lightingTexel() {
  LightingTexel lit;
  ivec2 texel = ivec2(gl_FragCoord.xy);
#if REDUCED
  ivec2 pixel = representativePixel(sampleAtTexel(texel, uLightingSize, vec2(textureSize(uGBufferSurface, 0))));
#else
  ivec2 pixel = representativeSample(texel, uLightingSize, textureSize(uGBufferSurface, 0));
#endif
  lit.depth = texelFetch(uDepth, pixel, 0).r;
  lit.onScreen = (vec2(pixel) + 0.5) / vec2(textureSize(uGBufferSurface, 0));
  vec4 placed = uWorldFromClip * vec4(vec3(lit.onScreen, lit.depth) * 2.0 - 1.0, 1.0);
  lit.position = placed.xyz / placed.w;
  vec4 surface = texelFetch(uGBufferSurface, pixel, 0);
#if REDUCED
  lit.normal = normalize(surface.rgb * 2.0 - 1.0);
  float code = floor(surface.a * 255.0 + 0.5);
  lit.material = floor(code / ROUGHNESS_STEPS) / MATERIAL_STEPS;
  lit.roughness = mod(code, ROUGHNESS_STEPS) / (ROUGHNESS_STEPS - 1.0);
#else
  lit.normal = normalize(octahedralDecode(surface.rg));
  lit.material = surface.a;
  lit.roughness = surface.b;
#endif
  return lit;
}
