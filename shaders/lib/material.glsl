// Maps and numbers of a mesh's material.

uniform sampler2D uAlbedo;
uniform sampler2D uNormal;
uniform sampler2D uOcclusionRoughness;  // and metallic
uniform vec4 uBaseColor;
uniform float uOcclusionStrength;  // of the map, 0 to 1
uniform vec4 uSurface;             // roughness, metallic, normal scale, alpha cutoff
