#version 300 es
// A picture on a larger canvas: each pixel keeps its colour across half of its width, and turns into the
// next one's over the rest, which is sharper than to mix them all the way.
// In:  display colour.   Out: display colour.
#include "lib/precision.glsl"

uniform sampler2D uSource;

in vec2 vUv;

out vec4 oColor;

// How much faster than evenly.
const float SHARPNESS = 1.25;

void main() {
  vec2 size = vec2(textureSize(uSource, 0));
  vec2 place = vUv * size - 0.5;
  vec2 corner = floor(place);
  vec2 share = clamp((place - corner - 0.5) * SHARPNESS + 0.5, 0.0, 1.0);
  oColor = textureLod(uSource, (corner + 0.5 + share) / size, 0.0);
}
