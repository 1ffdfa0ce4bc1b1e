// The first bounce of moonlight, and the sky's light, from points of what they come from, each with a shadow cube: for
// 1 lx outside. Keller 1997, "Instant Radiosity". Needs lib/photometry.glsl, lib/moon.glsl.
#include "lib/shadow-tiles.glsl"
#include "lib/glossy-lobe.glsl"

uniform sampler2D uVirtualLights;  // a column each: position, m, and extent, m; normal, length 1
uniform sampler2D uVirtualFlux;    // gi/virtual-flux.frag
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
  vec2 onFace = point.xy / point.z;
  vec2 place = center + clamp(onFace * texels, 1.0 - 0.5 * tile, 0.5 * tile - 1.0) - 0.5;
  vec2 low = floor(place);
  vec2 share = place - low;
  ivec2 texel = ivec2(low);
  vec4 depths = vec4(
    texelFetch(uVirtualShadow, texel, 0).r, texelFetchOffset(uVirtualShadow, texel, 0, ivec2(1, 0)).r,
    texelFetchOffset(uVirtualShadow, texel, 0, ivec2(0, 1)).r, texelFetchOffset(uVirtualShadow, texel, 0, ivec2(1, 1)).r);
  // Inverse distance of the lit plane, which is linear across texels, as a multiple of the point's.
  vec3 scaled = n / dot(n, vec3(onFace, 1.0));
  float here = dot(scaled, vec3((low + 0.5 - center) / texels, 1.0));
  vec2 slope = scaled.xy / texels;
  vec4 plane = max(here + vec4(0.0, slope.x, slope.y, slope.x + slope.y), 1.0 / VIRTUAL_STEEPEST);
  float nearest = abs(point.z) * (1.0 - VIRTUAL_BIAS.y) - VIRTUAL_BIAS.x;
  vec4 casters = max(1.0 - depths, SHADOW_STEP) * (nearest / VIRTUAL_NEAR);
  vec4 lit = vec4(lessThanEqual(casters, plane));
  vec2 across = mix(lit.xz, lit.yw, share.x);
  return mix(across.x, across.y, share.y);
}

// A light as it is seen from a point.
struct VirtualLight {
  vec3 d;           // from the light, m
  vec3 L;           // to the light, length 1
  float squared;    // distance, m²
  float extent;     // m
  vec3 axis;        // its normal
  float facing;     // cosine between that and the way to the point, at least 0
};

VirtualLight virtualLightAt(int i, vec3 position) {
  vec4 origin = texelFetch(uVirtualLights, ivec2(i, 0), 0);
  VirtualLight v;
  v.d = position - origin.xyz;
  v.squared = max(dot(v.d, v.d), 1e-4);
  v.L = -v.d * inversesqrt(v.squared);
  v.extent = origin.w;
  v.axis = texelFetch(uVirtualLights, ivec2(i, 1), 0).xyz;
  v.facing = max(-dot(v.axis, v.L), 0.0);
  return v;
}

// Towards the point, without its shadow, cd.
vec3 virtualIntensity(VirtualLight v, int i) {
  vec3 intensity = texelFetch(uVirtualFlux, ivec2(i, 0), 0).rgb / PI;
  vec2 incident = texelFetch(uVirtualFlux, ivec2(i, 1), 0).rg;
  if (i < VIRTUAL_LIGHTS - PANE_LIGHTS) {
    vec3 toMoon = -moon.direction;
    float fresnel = fresnelSchlick(vec3(0.04), dot(-v.L, normalize(toMoon - v.L))).r;
    intensity += incident.r * fresnel * glossyLobe(incident.g, v.axis, toMoon, -v.L);
  } else {
    intensity *= paneShare(v.L);
  }
  return intensity * v.facing;
}

// Without shadows, lx: as on the axis of a disc, whose squared radius is twice the mean squared distance from its middle.
vec3 virtualIrradiance(VirtualLight v, int i, float NoL) {
  return virtualIntensity(v, i) / (v.squared + 2.0 * v.extent * v.extent) * NoL;
}
