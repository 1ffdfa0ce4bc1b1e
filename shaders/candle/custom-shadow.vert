#version 300 es
// A model as one face of a flame's shadow cube sees it.
#include "lib/precision.glsl"

layout(location = 0) in vec3 aPosition;

uniform mat4 uClipFromWorld;

out vec3 vPosition;  // m

void main() {
  vPosition = aPosition;
  gl_Position = uClipFromWorld * vec4(aPosition, 1.0);
}
