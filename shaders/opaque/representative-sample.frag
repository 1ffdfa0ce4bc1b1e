#version 300 es
// The G-buffer sample that represents each lighting texel: the one most similar to all around it, by normal and
// depth. Others would sometimes light a board by the joint beside it. A pane represents only panes: its lighting is the
// night's luminance over its small albedo, too bright for the window's bars.
// In:  G-buffer.   Out: number of the candidate, over 255.
#include "lib/precision.glsl"
#include "lib/octahedral.glsl"
#include "lib/depth.glsl"
#include "lib/gbuffer.glsl"

uniform sampler2D uGBufferSurface;
uniform vec2 uLightingSize;

out vec4 oRepresentative;

// Relative difference of depth that counts as much as a right angle.
const float DEPTH_WEIGHT = 0.2;
// Similarity by which a candidate has to exceed the central one.
const float HYSTERESIS = 0.02;
// Similarity that a pane loses: more than there is.
const float PANE_LOSS = 10.0;

// Normal, and inverse depth.
vec4 surfaceAt(ivec2 texel, out bool isPane) {
  ivec2 inside = clamp(texel, ivec2(0), textureSize(uGBufferSurface, 0) - 1);
  vec4 surface = texelFetch(uGBufferSurface, inside, 0);
  isPane = isGlass(surface.a);
  return vec4(normalize(octahedralDecode(surface.rg)), inverseDepth(texelFetch(uDepth, inside, 0).r));
}

void main() {
  const int COUNT = CANDIDATES * CANDIDATES;
  ivec2 center = sampleAtTexel(ivec2(gl_FragCoord.xy), uLightingSize, vec2(textureSize(uGBufferSurface, 0)));
  vec4 mean = vec4(0.0);
  bool isPane;
  for (int i = 0; i < COUNT; i++) mean += surfaceAt(center + candidateOffset(i), isPane) / float(COUNT);
  int representative = CENTER;
  float highest = -1e9;
  for (int i = 0; i < COUNT; i++) {
    vec4 surface = surfaceAt(center + candidateOffset(i), isPane);
    float similarity = dot(surface.xyz, mean.xyz) - abs(surface.w / mean.w - 1.0) / DEPTH_WEIGHT;
    if (i == CENTER) similarity += HYSTERESIS;
    if (isPane) similarity -= PANE_LOSS;
    if (similarity > highest) representative = i;
    highest = max(highest, similarity);
  }
  oRepresentative = vec4(float(representative) / 255.0, 0.0, 0.0, 1.0);
}
