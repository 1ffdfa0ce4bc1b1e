// Reprojection: current frame -> previous frame. Positions are uv and depth, 0 to 1.
// Needs lib/gbuffer.glsl.

uniform mat4 uPreviousFromCurrentRoom;
uniform mat4 uPreviousFromCurrentHeld;  // of what moves with the camera

// Mirrored at the frame's edges: a surface that comes into view resembles its neighbours.
vec2 previousUv(vec4 current, float isHeld) {
  vec4 previous = mix(uPreviousFromCurrentRoom * current, uPreviousFromCurrentHeld * current, isHeld);
  return 1.0 - abs(1.0 - abs(previous.xy / previous.w));
}

// 1 where the previous frame has another layer, held or room: filtered edges count, or they would leave an outline.
float isDisoccluded(float isHeld, float previousStored) {
  return abs(step(0.1 * HELD, previousStored) - isHeld);
}
