// The room's depth buffer, for what is drawn over it.

uniform sampler2D uDepth;

// The camera's planes, m: src/render/camera.ts.
const float NEAR_PLANE = 0.05;
const float FAR_PLANE = 60.0;

// Distance along the view axis, m, of a depth in [0, 1].
float linearDepth(float depth) {
  return NEAR_PLANE * FAR_PLANE / (FAR_PLANE - depth * (FAR_PLANE - NEAR_PLANE));
}

// Its inverse up to a factor: linear across a plane on the screen, as depth is.
float inverseDepth(float depth) {
  return FAR_PLANE / (FAR_PLANE - NEAR_PLANE) - depth;
}

// Soft particles: 1 in free space, 0 behind the room's surface, and a ramp of some width (m) before it.
float softParticleFade(float width) {
  float room = linearDepth(texelFetch(uDepth, ivec2(gl_FragCoord.xy), 0).r);
  return clamp((room - linearDepth(gl_FragCoord.z)) / width, 0.0, 1.0);
}
