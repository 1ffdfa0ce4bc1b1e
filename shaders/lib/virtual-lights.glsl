// The first bounce of moonlight, and the sky's light, from points of what they come from, each with a shadow cube: for
// 1 lx outside. Keller 1997, "Instant Radiosity". Needs lib/photometry.glsl, lib/relief.glsl, lib/moon.glsl.
#include "lib/shadow-tiles.glsl"

uniform sampler2D uVirtualLights;  // a column each: position, m, and extent, m; normal, length 1, and area, m²
uniform sampler2D uVirtualFlux;    // lm
uniform highp sampler2D uVirtualShadow;

const float VIRTUAL_NEAR = 0.008;  // near plane of the cubes, m
// A caster less far before the lit plane is the plane: metres, and a share of the distance.
const vec2 VIRTUAL_BIAS = vec2(0.01, 0.01);
// A plane seen edge on reaches no farther than this many times the distance of the point.
const float VIRTUAL_STEEPEST = 1.03;

// Share of the light of one cube that reaches a point: of four texels. `d`: from the light, m.
float virtualVisibility(vec3 d, vec3 facet, float slot) {
  bvec2 axis = shadowAxis(d);
  vec3 point = onShadowFace(d, axis);
  vec3 n = onShadowFace(facet, axis);
  float tile = float(textureSize(uVirtualShadow, 0).x / 3);
  float texels = 0.5 * tile / SHADOW_REACH;  // for a length of 1 on a face
  vec2 center = shadowTileCenter(axis, point.z, slot, tile);
  vec2 place = center + clamp(point.xy / point.z * texels, 1.0 - 0.5 * tile, 0.5 * tile - 1.0) - 0.5;
  vec2 low = floor(place);
  vec2 share = place - low;
  float offset = dot(n, point / point.z);
  float reach = abs(point.z);
  float nearest = reach * (1.0 - VIRTUAL_BIAS.y) - VIRTUAL_BIAS.x;
  vec4 lit;
  for (int i = 0; i < 4; i++) {
    vec2 texel = low + vec2(i & 1, i >> 1);
    float plane = offset / dot(n, vec3((texel + 0.5 - center) / texels, 1.0));  // as a multiple of the point's distance
    plane = plane > 0.0 ? min(plane, VIRTUAL_STEEPEST) : VIRTUAL_STEEPEST;
    float caster = VIRTUAL_NEAR / max(1.0 - texelFetch(uVirtualShadow, ivec2(texel), 0).r, SHADOW_STEP);
    lit[i] = caster < plane * nearest ? 0.0 : 1.0;
  }
  vec2 across = mix(lit.xz, lit.yw, share.x);
  return mix(across.x, across.y, share.y);
}

// Direction to the point of a light nearest to a reflected ray. Karis 2013, "Real Shading in Unreal Engine 4".
vec3 representative(vec3 toLight, vec3 ray, float radius) {
  vec3 across = dot(toLight, ray) * ray - toLight;
  return normalize(toLight + across * min(radius / max(length(across), 1e-4), 1.0));
}

// Luminance that a surface reflects of the lights, cd/m². `facet`: normal of the triangle. `seen`: 1 or 0: shadows,
// specular.
float virtualLuminance(Shading s, vec3 position, vec3 facet, float diffuse, vec2 seen) {
  float sum = 0.0;
  vec3 reflected = reflect(-s.view, s.normal);
  for (int i = 0; i < VIRTUAL_LIGHTS; i++) {
    vec4 origin = texelFetch(uVirtualLights, ivec2(i, 0), 0);
    vec3 axis = texelFetch(uVirtualLights, ivec2(i, 1), 0).xyz;
    vec3 d = position - origin.xyz;
    float extent = origin.w;
    float squared = max(dot(d, d), 1e-4);
    vec3 L = -d * inversesqrt(squared);
    float NoL = dot(s.normal, L);
    float intensity = texelFetch(uVirtualFlux, ivec2(i, 0), 0).r / PI * max(-dot(axis, L), 0.0);
    if (min(intensity, NoL) <= 0.0) continue;
    if (i >= VIRTUAL_LIGHTS - PANE_LIGHTS) intensity *= paneShare(L);
    vec3 R = representative(-d, reflected, extent);
    vec3 H = normalize(R + s.view);
    float lobe = widenedLobe(s.alpha, extent * inversesqrt(squared), dot(s.normal, H), s.NoV, NoL);
    lobe *= luma(fresnelSchlick(s.f0, max(dot(R, H), 0.0)));
    float share = diffuse / PI * normalMapVisibility(s.surface, s.normal, L) * s.minified.y + lobe * seen.y;
    float visibility = mix(1.0, virtualVisibility(d, facet, float(i)), seen.x);
    sum += intensity / max(squared, extent * extent) * NoL * visibility * share;
  }
  return sum;
}
