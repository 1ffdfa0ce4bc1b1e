#version 300 es
// Forward shading of a mesh for a moon of 1 lx alone, and the night behind panes: the first bounce casts shadows.
// PREPASS: a tile of the refined image, of which hidden fragments are not shaded.
// Out: nothing for a flame; alpha: luminance for 1 lx. Rod vision needs no more.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/normal-map.glsl"
#include "lib/relief.glsl"
#include "lib/brdf.glsl"
#include "lib/environment-brdf.glsl"
#include "lib/irradiance-volume.glsl"
#include "lib/surface.glsl"
#ifdef PREPASS
#include "lib/prepass.glsl"
#endif
#include "lib/moon.glsl"
#include "lib/moon-shadow.glsl"
#include "lib/night-sky.glsl"
#include "lib/direct-moonlight.glsl"
#include "lib/virtual-lights.glsl"

uniform sampler2D uEnvironmentBrdf;
uniform vec4 uFeatures;  // 1 or 0: shadows, indirect light, specular; whether the camera moves
uniform vec2 uOrigin;    // of the target on the frame, pixels

out vec4 oRadiance;

// Alpha from which the virtual lights' reflections are the same in all directions while the camera moves.
const float ROUGH_IN_MOTION = 0.5;

// Direction to the point of a light nearest to a reflected ray. Karis 2013, "Real Shading in Unreal Engine 4".
vec3 representative(vec3 toLight, vec3 ray, float radius) {
  vec3 across = dot(toLight, ray) * ray - toLight;
  return normalize(toLight + across * min(radius / max(length(across), 1e-4), 1.0));
}

// Luminance that a surface reflects of the virtual lights, cd/m². `facet`: normal of the triangle. `mirrored`: share of
// light from all directions that it mirrors. A pane is so smooth that each light would be a disc on it.
float virtualLuminance(Shading s, vec3 position, vec3 facet, vec3 diffuseColor, vec3 mirrored, bool isPane) {
  float sum = 0.0;
  vec3 reflected = reflect(-s.view, s.normal);
  bool isMirroring = !isPane && (s.alpha < ROUGH_IN_MOTION || uFeatures.w < 0.5);
  vec3 evenly = isMirroring ? vec3(0.0) : mirrored / PI;
  for (int i = 0; i < VIRTUAL_LIGHTS; i++) {
    VirtualLight v = virtualLightAt(i, position);
    float NoL = dot(s.normal, v.L);
    if (min(v.facing, NoL) <= 0.0) continue;
    float visibility = mix(1.0, virtualVisibility(v.d, facet, float(i)), uFeatures.x);
    if (visibility <= 0.0) continue;
    vec3 specular = evenly;
    if (isMirroring) {
      vec3 R = representative(-v.d, reflected, v.extent);
      vec3 H = normalize(R + s.view);
      float shrunk = s.alpha / widenedAlpha(s.alpha, v.extent * inversesqrt(v.squared));
      float lobe = shrunk * shrunk * distributionGgx(s.alpha, max(dot(s.normal, H), 0.0));
      lobe *= visibilitySmith(s.alpha, s.NoV, NoL);
      specular = fresnelSchlick(s.f0, max(dot(R, H), 0.0)) * lobe;
    }
    vec3 share = diffuseColor / PI * normalMapVisibility(s.surface, s.normal, v.L) * s.minified.y;
    share += specular * uFeatures.z;
    sum += moonLuma(virtualIrradiance(v, i, NoL) * share) * visibility;
  }
  return sum;
}

float shade(vec3 facet) {
  cutOut();
  vec3 surface = directionOf(vNormalWorld) * (gl_FrontFacing ? 1.0 : -1.0);
  // Visibility and probes first, to save registers.
  float moonShare = visibilityOfMoon(surface, facet, uFeatures.x, gl_FragCoord.xy + uOrigin);
  vec3 normal = shadingNormal(surface);
  vec3 reflected = reflect(normalize(vPositionWorld - frame.eyePosition), normal);
  IrradianceSample probes = irradianceAt(vPositionWorld, 0.02, normal, normal, reflected);
  Material material = materialHere(occlusionRoughnessMetallicHere());
  Shading s = shadingOf(material, surface, normal);
  EnvironmentReflection environment = environmentReflection(uEnvironmentBrdf, s.f0, sqrt(s.alpha), s.NoV);
  // Reflected light does not reach the diffuse layer below.
  vec3 diffuseColor = material.baseColor * (1.0 - material.metallic) * (1.0 - environment.share);
  float laterBounces = moonLuma(probes.alongNormal * diffuseColor) * skyVisibility(surface, normal) * s.minified.x;
  float mirrored = moonLuma(probes.alongReflection * environment.share) * uFeatures.z;
  float unoccluded = 1.0 - NEAR_OCCLUSION * (1.0 - material.occlusion);
  float luminance = (laterBounces + mirrored) / PI * unoccluded * uFeatures.y;
  luminance += directMoonlight(s, moonShare, diffuseColor, uFeatures.z);
  bool isPane = material.roughness < PANE_ROUGHNESS && isOnPane(vPositionWorld);
  for (int i = isPane ? 1 : 0; i > 0; i--) luminance += nightThroughPane(-s.view, s.NoV);
  return luminance + virtualLuminance(s, vPositionWorld, facet, diffuseColor, environment.share, isPane) * uFeatures.y;
}

void main() {
  vec3 facet = facetNormal(vPositionWorld);
#ifdef PREPASS
  bool isVisible = isVisibleAt(ivec2(gl_FragCoord.xy + uOrigin));
  oRadiance = vec4(0.0);
  // Software renderers shade four pixels together: derivatives in a loop that some of them enter are right there.
  for (int i = isVisible ? 1 : 0; i > 0; i--) oRadiance = vec4(0.0, 0.0, 0.0, min(shade(facet), 3e4));
#else
  oRadiance = vec4(0.0, 0.0, 0.0, min(shade(facet), 3e4));
#endif
}
