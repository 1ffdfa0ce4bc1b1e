#version 300 es
// Geometry projected onto one face of a cube around a flame, or onto the moon's map: for shadows, and for surfels.
// CUTOUT: with the vertices' opacity.
#include "lib/precision.glsl"

layout(location = 0) in vec3 aPosition;
layout(location = 3) in vec2 aUv;
#ifdef CUTOUT
layout(location = 4) in vec4 aColor;
#endif
layout(location = 5) in float aSurface;

uniform mat4 uClipFromWorld;

out vec3 vPositionWorld;
out vec2 vUv;
flat out float vSurface;
#ifdef CUTOUT
out float vOpacity;
#endif

void main() {
  vPositionWorld = aPosition;
  vUv = aUv;
  vSurface = aSurface;
#ifdef CUTOUT
  vOpacity = aColor.a;
#endif
  gl_Position = uClipFromWorld * vec4(aPosition, 1.0);
}
