#version 300 es
// Vertices of the room or the upright candle.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/mesh-vertex.glsl"

uniform vec4 uWorldFromModel;  // origin of the model, m; w: metres per unit

out vec3 vPositionWorld;
out vec3 vNormalWorld;
out vec4 vTangentWorld;
out vec2 vUv;
out float vHeight;  // in the model's unit

void main() {
  vPositionWorld = uWorldFromModel.xyz + aPosition * uWorldFromModel.w;
  vNormalWorld = aNormal;
  vTangentWorld = aTangent;
  vUv = aUv;
  vHeight = aPosition.y;
  gl_Position = frame.clipFromWorld * vec4(vPositionWorld, 1.0);
}
