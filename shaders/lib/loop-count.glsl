// A loop's count that no compiler knows, so that it unrolls nothing: llvmpipe compiles in three quarters of the time.
// Needs lib/frame.glsl.
#define COUNT(n) (frame.viewport.x > 0.0 ? (n) : 0)
