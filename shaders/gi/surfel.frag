#version 300 es
// What the flame sees, coarsely: the surfaces that will light the rest of the room.
// Out: base colour, less what its relief hides; normal and distance from the flame (m, 0 where there is nothing).
#include "lib/precision.glsl"
#include "lib/normal-map.glsl"

uniform vec3 uLight;
uniform vec4 uBaseColor;
uniform sampler2D uAlbedo;
uniform sampler2D uNormal;
uniform float uRelief;  // scale of the normals

in vec3 vPositionWorld;
in vec2 vUv;

layout(location = 0) out vec4 oBaseColor;
layout(location = 1) out vec4 oNormalDistance;

void main() {
  vec3 fromLight = vPositionWorld - uLight;
  vec3 normal = cross(dFdx(vPositionWorld), dFdy(vPositionWorld));
  // A triangle smaller than a pixel has no slope.
  normal = dot(normal, normal) > 0.0 ? normalize(normal) : -normalize(fromLight);
  vec3 baseColor = texture(uAlbedo, vUv).rgb * uBaseColor.rgb;
  oBaseColor = vec4(baseColor * meanSkyVisibility(uNormal, vUv, uRelief), 1.0);
  oNormalDistance = vec4(faceforward(normal, fromLight, normal), length(fromLight));
}
