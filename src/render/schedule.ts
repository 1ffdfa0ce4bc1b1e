/**
 * How often each part of the frame is updated. `quality.ts` says how well.
 *
 * At rest everything is updated when what it depends on has changed, and in a stepped frame at once. What is listed here
 * holds for running animations: for indirect light, for the tier that draws a G-buffer, and for caches.
 */
export const SCHEDULE = {
  /** In motion every other frame is reprojected from the one before. */
  reprojection: {
    /** Distance of the surface by which motion in the image is judged, metres. */
    distance: 2,
    /** Largest motion between two frames, as a share of the image's size. */
    motion: 0.08,
  },
  /**
   * Frames in motion after which forward shading shades a pixel again: by a flame that moves, and in still light. Frames
   * that it counts as motion from the last one in which the camera moved.
   */
  checkerboard: { turns: 2, stillTurns: 4, settlingFrames: 4 },
  /** Frames in motion after the first, or after one that draws with a new program, that make and compile nothing. */
  quietFrames: 3,
  /**
   * Progressive refinement: frames over which a full G-buffer is filled after the camera stops or the size changes, and
   * pixels in a frame of the one that a refined image begins with.
   */
  refinement: { surfaces: 12, guide: 4, pixels: 76_800 },
  /** Shadow cube in motion: every fourth frame, sixth if those are busy, at once if the light moved this far (m). */
  shadow: { frames: 4, busyFrames: 6, distance: 0.25 },
  /** Surfels and probes: faces of the surfel cube or passes over the probes in a frame, frames of rest after an update. */
  indirect: { steps: 2, restFrames: 7 },
  /** Bloom and exposure: after so many frames at rest; in motion in each, without a GPU in idle ones, or after this many. */
  post: { frames: 5, restFrames: 1 },
  /** Steps in which normal-map shading of the G-buffer follows the light, metres; of the moon's direction. */
  normalMapShading: 0.05,
  /**
   * Steps in which shading follows the light: of its position (metres), and of its axis. Those of the deferred stage
   * are hidden by its coarser lighting; in forward shading they would show beside the flame.
   */
  lighting: {
    deferred: { distance: 0.0015, axis: 1 / 16 },
    forward: { distance: 0.0003, axis: 1 / 64 },
    /**
     * Where only the flame sways, forward shading follows it in one of these tiles every other frame; every fourth while
     * the flame moves less than this far in between (m), as the default draught moves it.
     */
    restTiles: { rows: 3, columns: 4 },
    calm: 0.001,
  },
  /** Samples of forward shading in motion, as shares of those at rest: on GPUs they take half of a frame. */
  samplesInMotion: { shadow: 2 / 3, reflection: 1 / 2 },
  /** Probes traced in a frame while a renderer is prepared: a few milliseconds. */
  probesPerFrame: 16,
} as const;
