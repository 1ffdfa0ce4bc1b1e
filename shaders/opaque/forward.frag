#version 300 es
// Forward shading of a mesh, for a flame of 1 cd; MOONLIT: and for a moon of 1 lx, with the night behind panes.
// GLOSSY: with reflections by rays, which take most of a GPU's registers, and panes.
// PREPASS: a tile of the refined image, of which hidden fragments are not shaded.
// CANDLES: for all flames as they burn, with the irradiance volume of all; standing candles with half the shadow taps.
// In:  base colour (sRGB), normal, occlusion/roughness/metallic maps; vertex colour: occlusion (red).
// Out: radiance per candela; or the normal, to inspect. MOONLIT: alpha: luminance per lux. Rod vision needs no more.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/normal-map.glsl"
#include "lib/relief.glsl"
#include "lib/flame-light.glsl"
#include "lib/pool-reflection.glsl"
#include "lib/flame-brdf.glsl"
#include "lib/environment-brdf.glsl"
#include "lib/pcss.glsl"
#include "lib/wax.glsl"
#ifdef GLOSSY
#include "lib/surfels.glsl"
#include "lib/distance-impostor.glsl"
#endif
#ifdef MOONLIT
#include "lib/moon.glsl"
#endif
#include "lib/irradiance-volume.glsl"

// Occlusion below which a point lies in a crevice.
const float CREVICE = 0.9;
// Roughness up to which reflections are traced, and from which the probes alone give them.
const vec2 TRACED_ROUGHNESS = vec2(0.15, 0.3);
// Metals are traced up to so much rougher: they show little else.
const float TRACED_METAL = 0.25;
// Surfaces nearer than the probes' spacing reflect the flame's light, by the baked occlusion, at most so many times the
// probes'. Fitted to a path tracer's indirect light in the cabin's views (`npm run reference`).
const float NEAR_REFLECTANCE = 0.3;
const float NEAR_LIMIT = 13.0;
// Height of a crevice's sides, m: they may be lit while its bottom is in shadow.
const float CREVICE_HEIGHT = 0.015;
// Mean cosine of the wick to the flame around it, dimmed by the dark zone.
const float WICK_COSINE = 0.05;

#include "lib/surface.glsl"
#ifdef PREPASS
#include "lib/prepass.glsl"
#endif
#ifdef MOONLIT
#include "lib/moon-shadow.glsl"
#include "lib/night-sky.glsl"
#include "lib/direct-moonlight.glsl"
#endif

uniform sampler2D uEnvironmentBrdf;
uniform float uWax;      // 1 or 0
uniform vec4 uFeatures;  // 1 or 0: shadows, indirect light, specular; the normal instead of radiance
uniform vec2 uOrigin;    // of the target on the frame, pixels
uniform float uIsWick;   // 1 or 0
uniform float uIsPane;   // 1 or 0
uniform vec3 uSamples;   // numbers of them: shadow taps of the blocker search, of the filter; rays of a rough surface's reflection

out vec4 oRadiance;

float footprint;  // of the pixel on the surface, m

// Visible share of the flame, past the room, the candle and its holder; and from a crevice's sides. Crevices are lit by
// their sides, whatever their own normal. `divisor`: of the number of taps.
vec2 visibilitiesOf(int divisor, vec3 surface, vec3 facet, bool isCrevice) {
  vec2 visibilities = vec2(0.0);
  if (uWax > 0.5 && isOwnWax(vPositionWorld)) return vec2(candleVisibility(vPositionWorld));
  if (dot(surface, light.position) > dot(surface, vPositionWorld) || isCrevice) {
    vec3 toward = faceforward(facet, vPositionWorld - light.position, facet);
    float rise = isCrevice ? CREVICE_HEIGHT * dot(surface, toward) : 0.0;
    vec2 pixel = gl_FragCoord.xy + uOrigin;
    float candle = candleVisibility(vPositionWorld);
    int search = candle > 0.0 ? int(uSamples.x) / divisor : 0;
    int taps = int(uSamples.y) / divisor;
    visibilities = candle * flameVisibility(search, taps, vPositionWorld, facet, rise, pixel, footprint);
  }
  return visibilities;
}

struct DirectLight {
  vec3 irradiance;  // lx
  vec3 sides;       // on a crevice's sides, at right angles, lx
  vec3 specular;    // cd/m², of single scattering
};

DirectLight directLight(Shading s, vec2 visibilities) {
  vec3 toLight = light.position - vPositionWorld;
  float distanceSquared = max(dot(toLight, toLight), LEAST_DISTANCE * LEAST_DISTANCE);
  vec3 L = toLight * inversesqrt(distanceSquared);
  float cosine = max(dot(s.normal, L), 0.0) * normalMapVisibility(s.surface, s.normal, L) * s.minified.y;
  if (uWax > 0.5) cosine = waxCosine(s.surface, vPositionWorld, toLight);
  float wickCosine = uIsWick * WICK_COSINE;
  float visibility = wickCosine > 0.0 ? 1.0 : visibilities.x;
  vec3 unshadowed = light.intensity / distanceSquared;
  vec3 perCosine = unshadowed * mix(1.0, visibility, uFeatures.x);
  float pool = withPool(toLight, distanceSquared);
  vec3 irradiance = perCosine * pool * max(cosine, wickCosine);
  if (uIsPane > 0.5) irradiance = min(irradiance, PANE_IRRADIANCE * light.intensity);
  vec3 sides = unshadowed * pool * mix(1.0, max(visibilities.x, visibilities.y), uFeatures.x);
  vec3 halfAxis = light.along * light.halfHeight;
  FlameSpecular flame = flameSpecular(toLight, halfAxis, light.radius, s.normal, s.view, s.NoV, s.alpha);
  return DirectLight(irradiance, sides, fresnelSchlick(s.f0, flame.SoH) * flame.lobe * perCosine * uFeatures.z);
}

// Radiance of the fragment. `facet`: normal of the triangle.
// Visibilities and probes come first, rays last: in between a GPU has too few registers for their loops.
vec4 shade(vec3 facet) {
  cutOut();
  vec3 surface = directionOf(vNormalWorld) * (gl_FrontFacing ? 1.0 : -1.0);
  vec3 occlusionRoughnessMetallic = occlusionRoughnessMetallicHere();
  bool isCrevice = occlusionRoughnessMetallic.x < CREVICE;
#ifdef CANDLES
  light = carried;
#endif
  vec2 visibilities = visibilitiesOf(1, surface, facet, isCrevice);
#ifdef MOONLIT
  float moonShare = visibilityOfMoon(surface, facet, uFeatures.x, gl_FragCoord.xy + uOrigin);
#endif

  vec3 normal = shadingNormal(surface);
  vec3 reflected = reflect(normalize(vPositionWorld - frame.eyePosition), normal);
  IrradianceSample probes = irradianceAt(vPositionWorld, 0.02, normal, normal, reflected);

  Material material = materialHere(occlusionRoughnessMetallic);
  vec3 baseColor = material.baseColor;
  Shading s = shadingOf(material, surface, normal);
  DirectLight direct = directLight(s, visibilities);
  vec3 glow = vec3(0.0);     // of the standing candles' wax
  float carriedShare = 1.0;  // of the irradiance volume's light
#ifdef CANDLES
  float others = 1e-9;
  for (int i = 0; i < int(standing.count); i++) {
    isStanding = true;
    light = standing.candles[i];
    visibilities = visibilitiesOf(2, surface, facet, isCrevice);
    DirectLight more = directLight(s, visibilities);
    direct.irradiance += more.irradiance;
    direct.sides += more.sides;
    direct.specular += more.specular;
    glow += waxGlow(vPositionWorld);
    others += luma(light.intensity);
  }
  isStanding = false;
  light = carried;
  carriedShare = luma(light.intensity) / (luma(light.intensity) + others);
#endif

  EnvironmentReflection environment = environmentReflection(uEnvironmentBrdf, s.f0, sqrt(s.alpha), s.NoV);
  // Reflected light does not reach the diffuse layer below.
  vec3 diffuseColor = baseColor * (1.0 - material.metallic) * (1.0 - environment.share);
  vec3 radiance = diffuseColor / PI * direct.irradiance + direct.specular * environment.boost;
  radiance += baseColor * (glow + waxGlow(vPositionWorld)) * uWax;

  float near = 1.0 - material.occlusion;
  float unoccluded = 1.0 - NEAR_OCCLUSION * near;
  float sky = skyVisibility(surface, normal) * s.minified.x;
  // Nearby surfaces are taken to have this point's colour and distance from the flame.
  vec3 nearby = NEAR_REFLECTANCE * near * baseColor * direct.sides;
  nearby /= 1.0 + direct.sides / max(NEAR_LIMIT * probes.alongNormal, 1e-9);
  radiance += (probes.alongNormal * unoccluded + nearby) * diffuseColor * (sky / PI * uFeatures.y);
  vec3 mirrored = (probes.alongReflection * unoccluded + nearby) / PI;
#ifdef GLOSSY
  float traced = 1.0 - smoothstep(TRACED_ROUGHNESS.x, TRACED_ROUGHNESS.y, material.roughness - material.metallic * TRACED_METAL);
  mirrored = mix(mirrored, probes.alongReflection * ((1.0 - carriedShare) / PI), traced);
#endif
  vec3 mirroring = environment.share * (uFeatures.y * uFeatures.z);
  radiance += mirrored * mirroring;

#ifdef MOONLIT
  float moonlight = directMoonlight(s, moonShare, diffuseColor, uFeatures.z);
  float reflectance = moonLuma(diffuseColor) * sky + moonLuma(environment.share) * uFeatures.z;
  moonlight += probes.moonlight * reflectance * unoccluded / PI * uFeatures.y;
#ifdef GLOSSY
  bool isPane = material.roughness < PANE_ROUGHNESS && isOnPane(vPositionWorld);
  for (int i = isPane ? 1 : 0; i > 0; i--) moonlight += nightThroughPane(-s.view, s.NoV);
#endif
#endif
#ifdef GLOSSY
  if (traced > 0.0) {
    // Rays hit what the carried flame lights; what others light is taken from the probes. They spread as the normals
    // within a pixel do: the rim of a dish would be dots.
    vec3 factor = mirroring * traced;
    vec3 beyond = probes.alongReflection * (carriedShare * TRACED_INDIRECT / PI);
    radiance += factor * traceReflection(vPositionWorld + surface * 0.01, normal, s.alpha, int(uSamples.z), beyond);
  }
#endif
  // The largest half float is 65504; a mirrored flame can be brighter.
  vec4 result = vec4(uFeatures.w > 0.5 ? 0.5 + 0.5 * normal : min(radiance, 3e4), 1.0);
#ifdef MOONLIT
  result.a = min(moonlight, 3e4);
#endif
  return result;
}

void main() {
  vec3 facet = facetNormal(vPositionWorld);
  footprint = min(length(dFdx(vPositionWorld)), length(dFdy(vPositionWorld)));
#ifdef PREPASS
  bool isVisible = isVisibleAt(ivec2(gl_FragCoord.xy + uOrigin));
  oRadiance = vec4(0.0);
  // Software renderers shade four pixels together: derivatives in a loop that some of them enter are right there.
  for (int i = isVisible ? 1 : 0; i > 0; i--) oRadiance = shade(facet);
#else
  oRadiance = shade(facet);
#endif
}
