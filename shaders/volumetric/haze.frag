#version 300 es
// What is behind the hot column, bent by it: thin air refracts less, so rays turn towards the cold.
// In:  radiance of the room, cd/m².   Out: the same, from where the ray came.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/depth.glsl"

uniform sampler2D uRadiance;
uniform vec2 uCorner;  // of what is drawn, in the picture, pixels

#if OFFSET
const float FULL = 4.0;  // pixels that show in full colour
#endif

in float vAcross;
in float vBend;
in vec2 vSideways;

out vec4 oRadiance;

void main() {
  vec2 texel = 1.0 / vec2(textureSize(uRadiance, 0));
  vec2 here = (gl_FragCoord.xy + uCorner) * texel;
  float column = linearDepth(gl_FragCoord.z);
  float room = linearDepth(texture(uDepth, here).r);
  // The nearer a thing is behind the column, the less way a bent ray has to stray.
  float leverage = max(1.0 - column / room, 0.0);
  float angle = vBend * vAcross * exp(0.5 - 0.5 * vAcross * vAcross) * leverage;
  vec2 offset = vSideways * (angle * frame.projectionScale);
  vec2 from = here + offset * texel;
  // Nothing that stands before the column is bent, nor smeared into what is.
  bool isBehind = linearDepth(texture(uDepth, from).r) > column;
#if OFFSET
  oRadiance = vec4(0.5 + (isBehind ? offset / FULL : vec2(0.0)), 0.5, 1.0);
#else
  oRadiance = texture(uRadiance, isBehind ? from : here);
#endif
}
