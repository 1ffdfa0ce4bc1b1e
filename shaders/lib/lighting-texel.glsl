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
// 1 for a pane, else 0.
float isPane(float code) {
  return float(isGlass(floor(code * 255.0 / ROUGHNESS_STEPS) / MATERIAL_STEPS));
}

// Of four samples the one whose normal is most similar to all: a texel lit by a joint would be a visible spot. A
// pane represents only panes.
ivec2 representativePixel(ivec2 pixel) {
  const vec4 OFFSET = vec4(0.5, 0.5, 0.5, 0.0);
  ivec2 upperRight = min(pixel + 1, textureSize(uGBufferSurface, 0) - 1);
  ivec2 right = ivec2(upperRight.x, pixel.y);
  ivec2 upper = ivec2(pixel.x, upperRight.y);
  vec4 a = texelFetch(uGBufferSurface, pixel, 0) - OFFSET;
  vec4 b = texelFetch(uGBufferSurface, right, 0) - OFFSET;
  vec4 c = texelFetch(uGBufferSurface, upper, 0) - OFFSET;
  vec4 d = texelFetch(uGBufferSurface, upperRight, 0) - OFFSET;
  vec3 sum = a.xyz + b.xyz + c.xyz + d.xyz;
  vec4 similarity = vec4(dot(a.xyz, sum), dot(b.xyz, sum), dot(c.xyz, sum), dot(d.xyz, sum));
  similarity -= 10.0 * vec4(isPane(a.w), isPane(b.w), isPane(c.w), isPane(d.w));
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
