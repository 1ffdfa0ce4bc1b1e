#version 300 es
// The picture's exposure, one texel of it: what its brightness asks for, and what the eye is behind.
// In:  brightness of its parts.   Out: red: stops, where 0 shows 1 cd/m² as the display's white.
#include "lib/precision.glsl"

uniform sampler2D uBrightness;
uniform vec2 uLaw;     // stops of a picture of 1 cd/m², and how many less for one that is twice as bright
uniform vec2 uLimits;  // stops
uniform float uLag;    // stops by which the eye is open wider than it will be

out vec4 oExposure;

void main() {
  ivec2 size = textureSize(uBrightness, 0);
  float sum = 0.0;
  float weights = 1e-3;
  for (int y = 0; y < size.y; y++) {
    for (int x = 0; x < size.x; x++) {
      vec2 part = texelFetch(uBrightness, ivec2(x, y), 0).rg;
      sum += part.r * part.g;
      weights += part.g;
    }
  }
  float wanted = clamp(uLaw.x - uLaw.y * sum / weights, uLimits.x, uLimits.y);
  oExposure = vec4(clamp(wanted + uLag, uLimits.x, uLimits.y), 0.0, 0.0, 1.0);
}
