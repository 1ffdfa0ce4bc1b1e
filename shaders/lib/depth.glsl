// How far away the room is, for what floats in it.

uniform sampler2D uDepth;

// The camera's planes, m: src/render/camera.ts.
const float NEAR_PLANE = 0.05;
const float FAR_PLANE = 60.0;

// Distance along the line of sight, m, of a depth in [0, 1].
float linearDepth(float depth) {
  return NEAR_PLANE * FAR_PLANE / (FAR_PLANE - depth * (FAR_PLANE - NEAR_PLANE));
}

// Its inverse but for a factor: that changes evenly across a plane, as depth does.
float nearnessOf(float depth) {
  return FAR_PLANE / (FAR_PLANE - NEAR_PLANE) - depth;
}

// 1 in the open, 0 behind the room's surface, and a slope of some width (m) before it.
float softParticleFade(float width) {
  float room = linearDepth(texelFetch(uDepth, ivec2(gl_FragCoord.xy), 0).r);
  return clamp((room - linearDepth(gl_FragCoord.z)) / width, 0.0, 1.0);
}
