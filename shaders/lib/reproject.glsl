// Where what is seen was in the picture before. Places are across, up, depth.
// Needs lib/gbuffer.glsl.

// From places in the picture to those in the one before: of the room, and of what is carried.
uniform mat4 uPreviousFromCurrentRoom;
uniform mat4 uPreviousFromCurrentHeld;

// 1 for what goes with the eye, else 0.
float carried(float stored) {
  return step(0.5 * HELD, stored);
}

// What only now comes into sight is like what is beside it.
vec2 previousUv(vec4 here, float isHeld) {
  vec4 since = mix(uPreviousFromCurrentRoom * here, uPreviousFromCurrentHeld * here, isHeld);
  return 1.0 - abs(1.0 - abs(since.xy / since.w));
}

// 1 where it was hidden behind something carried, of which already an edge would be left behind as an outline.
float isDisoccluded(float isHeld, float before) {
  return abs(step(0.1 * HELD, before) - isHeld);
}
