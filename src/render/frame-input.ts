import type { mat4 } from "gl-matrix";
import type { Surface } from "../gl/gpu.js";
import type { World } from "../world/world.js";
import type { FrameSettings } from "./frame-settings.js";
import type { CaptureLight } from "./light-block.js";
import type { Mesh } from "./mesh/mesh.js";

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** Origin of a model (x, y, z; metres) and its turn about the vertical (radians). */
export type Placement = readonly [number, number, number, number];

/** The placement of a model that stands where it was made. */
export const AT_ORIGIN: Placement = [0, 0, 0, 0];

export interface ModelInstance {
  readonly meshes: readonly Mesh[];
  readonly placement: Placement;
  /** Whether it moves with the camera. */
  readonly isHeld: boolean;
}

export interface FrameInput {
  readonly screen: Surface;
  readonly world: World;
  readonly settings: FrameSettings;
  readonly clipFromWorld: mat4;
  /** The flame, 1 cd strong, at the point that the shadow cube and the surfels are captured from. */
  readonly captureLight: CaptureLight;
  readonly instances: readonly ModelInstance[];
  /** Of the candle, whether it is drawn or not. */
  readonly candlePlacement: Placement;
  /** Roots of the flames in the frame, the carried one's first: shares of its width and height; null behind the camera. */
  readonly flameUvs: readonly (readonly [number, number] | null)[];
}
