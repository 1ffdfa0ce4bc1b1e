// Vertex stage of a dust particle or a spark: its inputs, and its outputs to volumetric/mote.frag.
#include "particles/kernel.glsl"
#include "lib/frame.glsl"

uniform vec4 uEmitter;  // m; metres per unit of the layer
uniform float uSize;    // diameter, m
uniform float uExtrapolation;  // s from the last tick to the frame

flat out vec4 vLight;
flat out vec2 vStreak;
flat out vec2 vExtent;

// Position in the frame, m, after `moveParticle`.
vec3 extrapolatedPosition() {
  return uEmitter.xyz + (position + velocity * uExtrapolation) * uEmitter.w;
}
