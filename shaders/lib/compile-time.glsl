// What shortens llvmpipe's compile time, and a Mali's spills, and costs nothing at run time. Needs lib/frame.glsl.

// A loop's count that no compiler knows, so that it unrolls nothing: three quarters of the time.
#define COUNT(n) (frame.viewport.x > 0.0 ? (n) : 0)

// It compiles an opaque draw twice: for tiles that the draw covers, and for others. What may discard, it compiles once.
#define COMPILE_ONCE if (frame.viewport.x < 0.0) discard
