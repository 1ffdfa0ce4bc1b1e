#version 300 es
// Distance from the capture origin, m.
#include "lib/precision.glsl"

uniform vec3 uCaptureOrigin;  // m

in vec3 vPositionWorld;

out vec4 oDistance;

void main() {
  oDistance = vec4(distance(vPositionWorld, uCaptureOrigin), 0.0, 0.0, 1.0);
}
