#version 300 es
// Heat haze: the room behind the hot column, refracted. Hot air has a smaller index, so rays turn towards the cold.
// In:  radiance of the room, cd/m².   Out: the same, from the refracted pixel; SHOWS_OFFSET: the offset as a colour.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/depth.glsl"

uniform sampler2D uRadiance;
uniform vec2 uStripOrigin;  // of the strip in the frame, pixels

#if SHOWS_OFFSET
const float FULL_OFFSET = 4.0;  // offset of full colour, pixels
#endif

in float vAcross;
in float vDeflection;
in vec2 vSideways;

out vec4 oRadiance;

void main() {
  vec2 texel = 1.0 / vec2(textureSize(uRadiance, 0));
  vec2 here = (gl_FragCoord.xy + uStripOrigin) * texel;
  float column = linearDepth(gl_FragCoord.z);
  float room = linearDepth(texture(uDepth, here).r);
  // The nearer the background to the column, the smaller its apparent shift.
  float leverage = max(1.0 - column / room, 0.0);
  float angle = vDeflection * vAcross * exp(0.5 - 0.5 * vAcross * vAcross) * leverage;
  vec2 offset = vSideways * (angle * frame.projectionScale);
  vec2 from = here + offset * texel;
  // A foreground is neither refracted nor smeared into the background.
  bool isBehind = linearDepth(texture(uDepth, from).r) > column;
#if SHOWS_OFFSET
  oRadiance = vec4(0.5 + (isBehind ? offset / FULL_OFFSET : vec2(0.0)), 0.5, 1.0);
#else
  oRadiance = texture(uRadiance, isBehind ? from : here);
#endif
}
