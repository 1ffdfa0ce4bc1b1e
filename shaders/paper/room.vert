#version 300 es
// Vertices of the room, in world space.
#include "lib/precision.glsl"
#include "lib/frame.glsl"

layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec3 aNormal;
layout(location = 2) in vec4 aTangent;
layout(location = 3) in vec2 aUv;

out vec3 vPositionWorld;
out vec3 vNormalWorld;
out vec4 vTangentWorld;
out vec2 vUv;

void main() {
  vPositionWorld = aPosition;
  vNormalWorld = aNormal;
  vTangentWorld = aTangent;
  vUv = aUv;
  gl_Position = frame.clipFromWorld * vec4(aPosition, 1.0);
}
