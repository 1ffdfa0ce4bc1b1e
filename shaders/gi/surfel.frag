#version 300 es
// Captures surfels: the surfaces that the flame lights.
// Out: base colour, less the self-occlusion of the normal map; normal and distance from the capture origin (m, 0 where
// there is no surface).
#include "lib/precision.glsl"
#include "lib/normal-map.glsl"

uniform vec3 uCaptureOrigin;  // m
uniform vec4 uBaseColor;
uniform sampler2D uAlbedo;
uniform sampler2D uNormal;
uniform float uNormalScale;

in vec3 vPositionWorld;
in vec2 vUv;

layout(location = 0) out vec4 oBaseColor;
layout(location = 1) out vec4 oNormalDistance;

void main() {
  vec3 fromOrigin = vPositionWorld - uCaptureOrigin;
  vec3 normal = cross(dFdx(vPositionWorld), dFdy(vPositionWorld));
  // A triangle smaller than a pixel has no derivatives.
  normal = dot(normal, normal) > 0.0 ? normalize(normal) : -normalize(fromOrigin);
  vec3 baseColor = texture(uAlbedo, vUv).rgb * uBaseColor.rgb;
  oBaseColor = vec4(baseColor * meanSkyVisibility(uNormal, vUv, uNormalScale), 1.0);
  oNormalDistance = vec4(faceforward(normal, fromOrigin, normal), length(fromOrigin));
}
