#version 300 es
// The glowing tip of the wick, over the room's light.   Out: radiance to add, cd/m².
#include "lib/precision.glsl"
#include "lib/depth.glsl"
#include "lib/flame-light.glsl"

uniform vec3 uEmber;  // cd/m²

in vec3 vPositionWorld;

out vec4 oRadiance;

// What lies so far before it hides it, m.
const float HIDES = 0.004;

void main() {
  float room = linearDepth(texelFetch(uDepth, ivec2(gl_FragCoord.xy), 0).r);
  float isSeen = step(linearDepth(gl_FragCoord.z) - HIDES, room);
  oRadiance = vec4(uEmber * emberShare(vPositionWorld) * isSeen, 0.0);
}
