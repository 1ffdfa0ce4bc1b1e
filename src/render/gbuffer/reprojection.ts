import { mat4 } from "gl-matrix";
import type { Features } from "../../settings.js";
import { reprojectionMatrix, screenMotion } from "../camera.js";
import { AT_ORIGIN, type ModelInstance } from "../frame-input.js";
import { SCHEDULE } from "../schedule.js";

/** Matrices from the current frame to the previous one: uv and depth, 0 to 1. */
export interface Reprojection {
  readonly room: mat4;
  readonly held: mat4;
  /** Largest motion of the room in the image, as a share of its size. */
  readonly motion: number;
}

/** What a reduced G-buffer was drawn for: it may be reprojected to a frame that differs only by the camera. */
export interface ReprojectionSource {
  readonly clipFromWorld: mat4;
  /** Clip space from the space of the held candle. */
  readonly clipFromHeld: mat4;
  /** All else that it depends on. */
  readonly key: string;
}

export function reprojectionSource(
  instances: readonly ModelInstance[],
  clipFromWorld: mat4,
  features: Features,
): ReprojectionSource {
  const standing = instances.map(({ placement, isHeld }) => isHeld || placement);
  const [x, y, z, yaw] = instances.find(({ isHeld }) => isHeld)?.placement ?? AT_ORIGIN;
  const worldFromHeld = mat4.fromTranslation(mat4.create(), [x, y, z]);
  mat4.rotateY(worldFromHeld, worldFromHeld, yaw);
  return {
    clipFromWorld,
    clipFromHeld: mat4.multiply(worldFromHeld, clipFromWorld, worldFromHeld),
    key: JSON.stringify([standing, features]),
  };
}

/** Null if the frames differ by more than the camera, or by too much of it. */
export function reprojectionBetween(
  current: ReprojectionSource,
  previous: ReprojectionSource,
): Reprojection | null {
  if (current.key !== previous.key) return null;
  const room = reprojectionMatrix(current.clipFromWorld, previous.clipFromWorld);
  const motion = screenMotion(room, SCHEDULE.reprojection.distance);
  if (!(motion < SCHEDULE.reprojection.motion)) return null;
  return { room, held: reprojectionMatrix(current.clipFromHeld, previous.clipFromHeld), motion };
}
