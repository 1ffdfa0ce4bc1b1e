#version 300 es
// The light on what the eye sees, at a few pixels only: it varies slowly where surfaces do not.
// In:  surfaces, depth, shadow cube, irradiance volume.
// Out: roots, for each cd of the flame's, of what the albedo is to be multiplied by, cd/m², and what is added;
//      REDUCED: the inverse of how far away that is, but for a factor.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/brdf.glsl"
#include "lib/octahedral.glsl"
#include "lib/random.glsl"
#include "lib/depth.glsl"
#include "lib/flame-light.glsl"
#include "lib/pcss-reduced.glsl"
#include "lib/irradiance-volume.glsl"
#include "lib/wax.glsl"
#include "lib/gbuffer.glsl"
#if !REDUCED
#include "lib/representative-sample.glsl"
#endif
#include "lib/support-irradiance.glsl"

// A flame is no point: nearer than this the inverse square would not hold. Metres.
const float NEAREST = 0.01;

uniform sampler2D uGBufferSurface;
uniform vec3 uFeatures;  // 1 or 0: shadows, bounced light, highlights
uniform vec2 uLightingSize;
uniform mat4 uWorldFromClip;

layout(location = 0) out vec4 oLighting;
#if REDUCED
layout(location = 1) out vec4 oNearness;
#endif

#if REDUCED
// Of four pixels the one that lies most as all of them do: light in a joint would show as a spot around it.
ivec2 representativePixel(ivec2 pixel) {
  ivec2 beyond = min(pixel + 1, textureSize(uGBufferSurface, 0) - 1);
  ivec2 aside = ivec2(beyond.x, pixel.y);
  ivec2 above = ivec2(pixel.x, beyond.y);
  vec3 a = texelFetch(uGBufferSurface, pixel, 0).rgb - 0.5;
  vec3 b = texelFetch(uGBufferSurface, aside, 0).rgb - 0.5;
  vec3 c = texelFetch(uGBufferSurface, above, 0).rgb - 0.5;
  vec3 d = texelFetch(uGBufferSurface, beyond, 0).rgb - 0.5;
  vec3 sum = a + b + c + d;
  vec4 alike = vec4(dot(a, sum), dot(b, sum), dot(c, sum), dot(d, sum));
  vec2 most = max(alike.xy, alike.zw);
  ivec2 even = alike.x >= alike.z ? pixel : above;
  ivec2 odd = alike.y >= alike.w ? aside : beyond;
  return most.x >= most.y ? even : odd;
}
#endif

float fifthPower(float x) {
  float squared = x * x;
  return squared * squared * x;
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
#if REDUCED
  ivec2 pixel = representativePixel(sampleAtTexel(texel, uLightingSize, vec2(textureSize(uGBufferSurface, 0))));
#else
  ivec2 pixel = representativeSample(texel, uLightingSize, textureSize(uGBufferSurface, 0));
#endif
  float depth = texelFetch(uDepth, pixel, 0).r;
  vec2 onScreen = (vec2(pixel) + 0.5) / vec2(textureSize(uGBufferSurface, 0));
  vec4 placed = uWorldFromClip * vec4(vec3(onScreen, depth) * 2.0 - 1.0, 1.0);
  vec3 position = placed.xyz / placed.w;
  vec4 surface = texelFetch(uGBufferSurface, pixel, 0);
#if REDUCED
  oNearness = vec4(nearnessOf(depth), 0.0, 0.0, 1.0);
  vec3 normal = normalize(surface.rgb * 2.0 - 1.0);
  float code = floor(surface.a * 255.0 + 0.5);
  float material = floor(code / ROUGHNESS_STEPS) / MATERIAL_STEPS;
  float roughness = mod(code, ROUGHNESS_STEPS) / (ROUGHNESS_STEPS - 1.0);
#else
  vec3 normal = normalize(octahedralDecode(surface.rg));
  float material = surface.a;
  float roughness = surface.b;
#endif
  bool isWax = material > 0.75;
  float metallic = isWax ? 0.0 : min(material / METAL, 1.0);
  vec3 view = normalize(frame.eyePosition - position);
  float NoV = max(abs(dot(normal, view)), 1e-3);

  vec3 toLighting = light.position - position;
  float distanceSquared = max(dot(toLighting, toLighting), NEAREST * NEAREST);
  vec3 L = toLighting * inversesqrt(distanceSquared);
  float NoL = max(dot(normal, L), 0.0);
  // Four turns of the taps side by side, which mixing smooths.
  float visible = NoL > 0.0 ? flameVisibility(position, normal, mod(floor(gl_FragCoord.xy), 2.0)) : 0.0;
  float reaching = mix(1.0, visible * candleVisibility(position), uFeatures.x) / distanceSquared;
  vec3 H = normalize(L + view);
  float NoH = max(dot(normal, H), 0.0);
  float LoH = max(dot(L, H), 0.0);
  float alpha = roughness * roughness;
  float widened = clamp(alpha + 0.5 * light.radius * inversesqrt(distanceSquared), 0.0, 1.0);
  float narrowing = (alpha * alpha) / (widened * widened);
  float lobe = distributionGgx(widened, NoH) * visibilitySmith(alpha, NoV, NoL) * narrowing;
  float mirrored = lobe * NoL * reaching * uFeatures.z;
  float schlick = fifthPower(1.0 - LoH);
  float plain = 0.04 + 0.96 * schlick;  // of what is no metal
  vec3 perCandela = vec3((1.0 - metallic) * (1.0 - plain) / PI * NoL * reaching);
  float added = (1.0 - metallic) * plain * mirrored;
  perCandela += metallic * mirrored;

  vec3 reflected = reflect(-view, normal);
  IrradianceSample indirect = irradianceAt(position + normal * 0.08, normal, normal, reflected);
  float grazing = fifthPower(1.0 - NoV);
  float matt = (1.0 - metallic) * (1.0 - 0.04 - 0.96 * grazing) / PI;
  perCandela += (indirect.alongNormal + supportIrradiance(position, supportViewFactor(normal))) * (matt * uFeatures.y);
  vec3 room = (indirect.alongReflection + supportIrradiance(position, 0.5 - 0.5 * reflected.y)) / PI;
  room *= (1.0 - 0.6 * roughness) * uFeatures.y * uFeatures.z;
  perCandela += metallic * room;
  added += (1.0 - metallic) * (0.04 + 0.96 * grazing) * luma(room);
  if (isWax) perCandela += waxGlow(position);
  oLighting = sqrt(clamp(vec4(perCandela, added), 0.0, 3e4));
}
