// Flames of a model with several wicks, each a capsule of light.

const int MOST_FLAMES = 16;

layout(std140) uniform Flames {
  vec4 centres[MOST_FLAMES];      // m; half height, m
  vec4 alongs[MOST_FLAMES];       // direction of the axis, length 1; radius, m
  vec4 intensities[MOST_FLAMES];  // cd; slot of its shadow cube, or -1
  vec4 roots[MOST_FLAMES];        // of the flame, m; height above it from which its shadows are seen, m
  vec4 embers[MOST_FLAMES];       // radiance of the wick's glowing tip, cd/m²; height of its end above the root, m
  vec4 glares[MOST_FLAMES];       // centre of the light and its half height, uv; strength of the glare
  float count;
} flames;
