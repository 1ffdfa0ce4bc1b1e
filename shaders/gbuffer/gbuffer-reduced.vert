#version 300 es
// Vertices of the reduced G-buffer, with the direction to the light in tangent space.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/mesh-vertex.glsl"

uniform vec4 uPlacement;    // origin of the model, m
uniform vec2 uRotation;     // turn about the vertical: cosine, sine
uniform vec3 uCaptureOrigin;  // of the light, m

out vec3 vNormalWorld;
out vec3 vToLight;  // along tangent, bitangent and normal, m
out vec3 vUvAndOcclusion;

void main() {
  mat3 turn = mat3(uRotation.x, 0.0, -uRotation.y, 0.0, 1.0, 0.0, uRotation.y, 0.0, uRotation.x);
  vec3 position = uPlacement.xyz + turn * aPosition;
  vec3 normal = turn * aNormal;
  vec3 tangent = turn * aTangent.xyz;
  vec3 toLight = uCaptureOrigin - position;
  vNormalWorld = normal;
  vToLight = vec3(
    dot(tangent, toLight),
    dot(cross(normal, tangent) * aTangent.w, toLight),
    dot(normal, toLight)
  );
  vUvAndOcclusion = vec3(aUv, aColor.r);
  gl_Position = frame.clipFromWorld * vec4(position, 1.0);
}
