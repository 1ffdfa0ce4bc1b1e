#version 300 es
// One point for each ray's hit, on the texel of that ray.
#include "lib/precision.glsl"

layout(location = 0) in vec2 aTexel;
layout(location = 1) in vec2 aUv;

uniform vec2 uSize;  // of the target, texels

out vec2 vUv;

void main() {
  vUv = aUv;
  gl_Position = vec4((aTexel + 0.5) / uSize * 2.0 - 1.0, 0.0, 1.0);
  gl_PointSize = 1.0;
}
