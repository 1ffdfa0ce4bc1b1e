#version 300 es
// What the flame sees, one face of a cube at a time.
#include "lib/precision.glsl"

layout(location = 0) in vec3 aPosition;

uniform mat4 uClipFromWorld;

out vec3 vPositionWorld;

void main() {
  vPositionWorld = aPosition;
  gl_Position = uClipFromWorld * vec4(aPosition, 1.0);
}
