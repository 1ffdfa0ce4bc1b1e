#version 300 es
// The flame: light of soot and of the blue base, gathered along the ray, with a little absorption.
// In:  the body, over radius and height.   Out: radiance, cd/m², premultiplied by opacity.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/random.glsl"
#include "physical/flame.glsl"

uniform sampler2D uBody;     // emission, cd/m² per m; alpha: extinction, 1/m
uniform sampler2D uOutline;  // red: radius over height, share of the largest

in vec3 vPositionWorld;

out vec4 oRadiance;

vec4 bodyAt(vec3 position) {
  vec3 axis = flame.tip - flame.base;
  float height = (position.y - flame.base.y) / axis.y;
  if (height <= 0.0 || height >= 1.0) return vec4(0.0);
  // The spine leaves the wick upright and bends above it.
  vec2 centre = flame.base.xz + axis.xz * height * height;
  float outer = flame.radius * texture(uOutline, vec2(height, 0.5)).r;
  float share = length(position.xz - centre) / (max(outer, 1e-5) * BODY_REACH);
  return share < 1.0 ? texture(uBody, vec2(share, height)) : vec4(0.0);
}

void main() {
  vec3 direction = normalize(vPositionWorld - frame.eyePosition);
  vec3 axis = flame.tip - flame.base;
  // The way through a ball around the flame: never longer, and no face of the hull matters.
  float reach = 0.5 * length(axis) + flame.radius * BODY_REACH;
  vec3 fromCentre = frame.eyePosition - (flame.base + 0.5 * axis);
  float b = dot(fromCentre, direction);
  float chord = b * b - dot(fromCentre, fromCentre) + reach * reach;
  if (chord <= 0.0) discard;
  // Seen from the side only the slab around the axis counts.
  vec2 flat_ = direction.xz;
  float sideways = length(flat_);
  float half_ = min(sqrt(chord), (flame.radius * BODY_REACH + length(axis.xz)) / max(sideways, 1e-3));
  vec2 toAxis = (flame.base.xz + 0.5 * axis.xz) - frame.eyePosition.xz;
  float middle = sideways > 0.05 ? dot(toAxis, flat_) / (sideways * sideways) : -b;
  float begin = max(middle - half_, 0.0);
  float stride = (middle + half_ - begin) / flame.steps;
  uint seed = pcg(uint(gl_FragCoord.x) + pcg(uint(gl_FragCoord.y)));
  vec3 radiance = vec3(0.0);
  float transmittance = 1.0;
  for (float i = 0.0; i < flame.steps; i++) {
    vec4 body = bodyAt(frame.eyePosition + direction * (begin + (i + unit(seed)) * stride));
    radiance += transmittance * body.rgb * stride;
    transmittance *= exp(-body.a * stride);
  }
  // The largest half float is 65504.
  oRadiance = vec4(min(radiance, 3e4), 1.0 - transmittance);
}
