import { clipFromWorld, projectionScale } from "../../src/render/camera.js";

/** What all peers draw: the paper's core flame in metres, from a wide burner so that it can be seen. */
export const LAW = {
  spawnRadius: 0.4,
  spawnHeight: 0,
  speed: [1.0, 1.5],
  sideSpeed: 0.05,
  buoyancy: 0.5,
  drift: 0.1,
  life: 0.7,
} as const;

export const WIDTH = 800;
export const HEIGHT = 600;
/** One frame of the peers, s. */
export const FRAME = 1 / 60;

// The flame is 1.2 m high and 1 m wide; seen from here, it fills half of the picture.
const DISTANCE = 1.7;
const EYE = [0, 0.58, DISTANCE] as const;

export const VIEW = {
  eye: EYE,
  clipFromWorld: clipFromWorld([...EYE], 0, 0, WIDTH / HEIGHT),
  projectionScale: projectionScale(HEIGHT),
} as const;

/** Diameter in metres of a sprite that is `pixels` wide in the middle of the flame. */
export function sizeOf(pixels: number): number {
  return (pixels * DISTANCE) / VIEW.projectionScale;
}

/** One cell of the table. */
export interface Cell {
  /** Particles alive. */
  readonly count: number;
  /** Width of a sprite at birth. */
  readonly pixels: number;
}
