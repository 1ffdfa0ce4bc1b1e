// Constants of a frame: camera and exposure.

layout(std140) uniform Frame {
  mat4 clipFromWorld;
  vec3 eyePosition;      // m
  float exposure;        // linear factor before the display transform
  vec2 viewport;         // pixels
  float projectionScale; // size of 1 m at a distance of 1 m, pixels
  float normalMaps;      // 1 or 0
} frame;
