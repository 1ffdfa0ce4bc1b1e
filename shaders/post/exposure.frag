#version 300 es
// Automatic exposure, one texel: by the metered luminance and the lag of the eye's adaptation.
// In:  metered cells.   Out: red: stops, where 0 shows 1 cd/m² as the display's white.
#include "lib/precision.glsl"

uniform sampler2D uLogLuminance;
uniform vec2 uLaw;     // stops for 1 cd/m², and how many less for every doubling of it
uniform vec2 uLimits;  // stops
uniform float uLag;    // stops by which the exposure is above its settled value

out vec4 oExposure;

void main() {
  ivec2 size = textureSize(uLogLuminance, 0);
  float sum = 0.0;
  float weights = 1e-3;
  for (int y = 0; y < size.y; y++) {
    for (int x = 0; x < size.x; x++) {
      vec2 cell = texelFetch(uLogLuminance, ivec2(x, y), 0).rg;
      sum += cell.r * cell.g;
      weights += cell.g;
    }
  }
  float settled = clamp(uLaw.x - uLaw.y * sum / weights, uLimits.x, uLimits.y);
  oExposure = vec4(clamp(settled + uLag, uLimits.x, uLimits.y), 0.0, 0.0, 1.0);
}
