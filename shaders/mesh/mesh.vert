#version 300 es
// Vertices of a mesh: the room, or the candle at its placement.
#include "lib/precision.glsl"
#include "lib/frame.glsl"

layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec3 aNormal;
layout(location = 2) in vec4 aTangent;
layout(location = 3) in vec2 aUv;
layout(location = 4) in vec4 aColor;

uniform vec4 uPlacement;  // of the model's origin, m; w: yaw, rad

centroid out vec3 vPositionWorld;
centroid out vec3 vNormalWorld;
centroid out vec4 vTangentWorld;
centroid out vec2 vUv;
centroid out vec4 vColor;

vec3 rotateYaw(vec3 v) {
  float c = cos(uPlacement.w);
  float s = sin(uPlacement.w);
  return vec3(c * v.x + s * v.z, v.y, c * v.z - s * v.x);
}

void main() {
  vPositionWorld = uPlacement.xyz + rotateYaw(aPosition);
  vNormalWorld = rotateYaw(aNormal);
  vTangentWorld = vec4(rotateYaw(aTangent.xyz), aTangent.w);
  vUv = aUv;
  vColor = aColor;
  gl_Position = frame.clipFromWorld * vec4(vPositionWorld, 1.0);
}
