#version 300 es
// Anything solid: the room, or the candle carried through it.
#include "lib/precision.glsl"
#include "lib/frame.glsl"

layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec3 aNormal;
layout(location = 2) in vec4 aTangent;
layout(location = 3) in vec2 aUv;
layout(location = 4) in vec4 aColor;

uniform vec4 uPlacement;  // where the model's origin is, m; w: its turn about the vertical, rad

centroid out vec3 vPositionWorld;
centroid out vec3 vNormalWorld;
centroid out vec4 vTangentWorld;
centroid out vec2 vUv;
centroid out vec4 vColor;

vec3 turned(vec3 v) {
  float c = cos(uPlacement.w);
  float s = sin(uPlacement.w);
  return vec3(c * v.x + s * v.z, v.y, c * v.z - s * v.x);
}

void main() {
  vPositionWorld = uPlacement.xyz + turned(aPosition);
  vNormalWorld = turned(aNormal);
  vTangentWorld = vec4(turned(aTangent.xyz), aTangent.w);
  vUv = aUv;
  vColor = aColor;
  gl_Position = frame.clipFromWorld * vec4(vPositionWorld, 1.0);
}
