#version 300 es
// Automatic exposure, one texel: by the metered luminance and the lag of the eye's adaptation.
// In:  metered cells; the room's reflectance.   Out: red: stops, where 0 shows 1 cd/m² as the display's white.
#include "lib/precision.glsl"

uniform sampler2D uLogLuminance;
uniform vec2 uLaw;     // stops for 1 cd/m², and how many less for every doubling of it
uniform vec2 uLimits;  // stops
uniform sampler2D uRoomReflectance;
uniform vec2 uKey;     // reflectance of a room whose key is 1, and stops more for every doubling of it
uniform float uLag;    // stops by which the exposure is above its settled value

out vec4 oExposure;

void main() {
  // Each tap is the mean of four cells.
  ivec2 taps = textureSize(uLogLuminance, 0) / 2;
  vec2 sum = vec2(0.0, 1e-5);
  for (int y = 0; y < taps.y; y++) {
    for (int x = 0; x < taps.x; x++) sum += textureLod(uLogLuminance, (vec2(x, y) + 0.5) / vec2(taps), 0.0).rg;
  }
  // A white room is shown bright, a dark one dark.
  float reflectance = max(texelFetch(uRoomReflectance, ivec2(0), 0).r, 0.05);
  float key = uKey.y * log2(reflectance / uKey.x);
  float settled = clamp(uLaw.x - uLaw.y * sum.x / sum.y, uLimits.x, uLimits.y);
  oExposure = vec4(clamp(settled + uLag, uLimits.x, uLimits.y) + key, 0.0, 0.0, 1.0);
}
