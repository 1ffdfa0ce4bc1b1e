// A fragment of a mesh: its material, and what mesh/mesh.vert gives.
#include "lib/material.glsl"

// `centroid`: beyond the edge of a thin triangle attributes are extrapolated.
centroid in vec3 vPositionWorld;
centroid in vec3 vNormalWorld;
centroid in vec4 vTangentWorld;
centroid in vec2 vUv;
centroid in vec4 vColor;

// Bias of the level of detail: the hardware's choice blurs more than a pixel.
const float LOD_BIAS = -0.5;
