#version 300 es
// Captures surfels: the surfaces that the flame lights; MOON: that the moon's does.
// Out: reflectance, less the self-occlusion of the normal map, and gloss; normal and distance from the capture origin (m, 0 where
// there is no surface).
#include "lib/precision.glsl"
#include "lib/caster-albedo.glsl"

uniform vec3 uCaptureOrigin;  // m; MOON: a point of the plane that distances are from
#ifdef MOON
uniform vec3 uDirection;  // of the light, length 1
#endif
uniform sampler2D uCasterAlbedo;

in vec3 vPositionWorld;
in vec2 vUv;
flat in float vSurface;  // number of its tile

layout(location = 0) out vec4 oReflectance;
layout(location = 1) out vec4 oNormalDistance;

// Reflectance at a level of detail, filtered as a texture that repeats.
vec4 reflectanceAtLevel(vec2 uv, int level) {
  int size = casterLevelSize(level);
  ivec2 tile = casterTile(int(vSurface)) + ivec2(0, casterLevelRow(level));
  vec2 place = fract(uv) * float(size) - 0.5;
  vec2 share = fract(place);
  ivec2 low = (ivec2(floor(place)) + size) % size;
  ivec2 high = (low + 1) % size;
  vec4 left = mix(texelFetch(uCasterAlbedo, tile + low, 0), texelFetch(uCasterAlbedo, tile + ivec2(low.x, high.y), 0), share.y);
  vec4 right = mix(texelFetch(uCasterAlbedo, tile + ivec2(high.x, low.y), 0), texelFetch(uCasterAlbedo, tile + high, 0), share.y);
  return mix(left, right, share.x);
}

// Mean of the reflectance over a pixel.
vec4 reflectanceAt(vec2 uv) {
  vec2 across = dFdx(uv) * float(CASTER_TILE);
  vec2 up = dFdy(uv) * float(CASTER_TILE);
  float footprint = max(max(dot(across, across), dot(up, up)), 1.0);  // texels, squared
  float level = min(0.5 * log2(footprint), float(CASTER_LEVELS - 1));
  int finer = int(level);
  int coarser = min(finer + 1, CASTER_LEVELS - 1);
  return mix(reflectanceAtLevel(uv, finer), reflectanceAtLevel(uv, coarser), fract(level));
}

void main() {
  vec3 fromOrigin = vPositionWorld - uCaptureOrigin;
#ifdef MOON
  fromOrigin = uDirection * dot(fromOrigin, uDirection);
#endif
  vec3 normal = cross(dFdx(vPositionWorld), dFdy(vPositionWorld));
  // A triangle smaller than a pixel has no derivatives.
  normal = dot(normal, normal) > 0.0 ? normalize(normal) : -normalize(fromOrigin);
  oReflectance = reflectanceAt(vUv);
  oNormalDistance = vec4(faceforward(normal, fromOrigin, normal), length(fromOrigin));
}
