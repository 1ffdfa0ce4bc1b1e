#version 300 es
// Shadow casters, projected onto one face of the shadow cube.
#include "lib/precision.glsl"

layout(location = 0) in vec3 aPosition;

uniform mat4 uClipFromWorld;

void main() {
  gl_Position = uClipFromWorld * vec4(aPosition, 1.0);
}
