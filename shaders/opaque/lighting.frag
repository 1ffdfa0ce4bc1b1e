#version 300 es
// The light on what the eye sees, at a few pixels only: it varies slowly where surfaces do not.
// In:  surfaces, depth, shadow cube, irradiance volume.
// Out: roots, for each cd of the flame's, of what the albedo is to be multiplied by, cd/m², and what is added;
//      REDUCED: the inverse of how far away that is, but for a factor.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/octahedral.glsl"
#include "lib/random.glsl"
#include "lib/depth.glsl"
#include "lib/flame-light.glsl"
#include "lib/flame-brdf.glsl"
#include "lib/pcss.glsl"
#include "lib/irradiance-volume.glsl"
#include "lib/wax.glsl"
#include "lib/gbuffer.glsl"
#if !REDUCED
#include "lib/representative-sample.glsl"
#endif
#include "lib/support-irradiance.glsl"

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

  vec3 toLight = light.position - position;
  float distanceSquared = max(dot(toLight, toLight), LEAST_DISTANCE * LEAST_DISTANCE);
  vec3 L = toLight * inversesqrt(distanceSquared);
  float NoL = max(dot(normal, L), 0.0);
  // Four rotations of the taps side by side, which the upsampling averages.
  vec2 tile = mod(floor(gl_FragCoord.xy), 2.0);
  float visibility = NoL > 0.0 ? flameVisibility(position, normal, tile) * candleVisibility(position) : 0.0;
  float perArea = mix(1.0, visibility, uFeatures.x) / distanceSquared;
  FlameSpecular flame = flameSpecular(toLight, normal, view, NoV, roughness * roughness);
  float fresnel = fresnelSchlick(vec3(0.04), flame.SoH).r;  // of a dielectric; a metal's is its albedo
  float specular = flame.lobe * perArea * uFeatures.z;
  // What the albedo is multiplied by, and what is added to it.
  vec3 perCandela = vec3((1.0 - metallic) * (1.0 - fresnel) / PI * NoL * perArea + metallic * specular);
  float added = (1.0 - metallic) * fresnel * specular;

  vec3 reflected = reflect(-view, normal);
  IrradianceSample indirect = irradianceAt(position + normal * 0.08, normal, normal, reflected);
  float mirrored = fresnelSchlick(vec3(0.04), NoV).r;
  float diffuse = (1.0 - metallic) * (1.0 - mirrored) / PI;
  perCandela += (indirect.alongNormal + supportIrradiance(position, supportViewFactor(normal))) * (diffuse * uFeatures.y);
  vec3 room = (indirect.alongReflection + supportIrradiance(position, 0.5 - 0.5 * reflected.y)) / PI;
  room *= (1.0 - 0.6 * roughness) * uFeatures.y * uFeatures.z;
  perCandela += metallic * room;
  added += (1.0 - metallic) * mirrored * luma(room);
  if (isWax) perCandela += waxGlow(position);
  oLighting = sqrt(clamp(vec4(perCandela, added), 0.0, 3e4));
}
