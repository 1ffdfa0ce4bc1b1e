// What is the same for every draw of a frame.

layout(std140) uniform Frame {
  mat4 clipFromWorld;
  vec3 eyePosition;      // m
  float exposure;        // linear factor before display
  vec2 viewport;         // pixels
  float projectionScale; // pixels that a thing of 1 m has at a distance of 1 m
  float normalMaps;      // 1 or 0
} frame;
