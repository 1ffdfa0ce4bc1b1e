import { mat4, vec4 } from "gl-matrix";
import type { Features } from "../../settings.js";
import { FAR, NEAR } from "../camera.js";
import { AT_ORIGIN, type ModelInstance } from "../frame-input.js";
import { SCHEDULE } from "../schedule.js";

/** From clip space, -1 to 1, to uv and depth, and back: by columns. */
const PLACE_FROM_CLIP: mat4 = [0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0.5, 0.5, 0.5, 1];
const CLIP_FROM_PLACE: mat4 = [2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, -1, -1, -1, 1];

/** Matrices from the current frame to an earlier one: uv and depth, 0 to 1. */
export interface Reprojection {
  readonly room: Float32Array;
  readonly held: Float32Array;
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
  const worldFromHeld = mat4.create();
  mat4.translate(worldFromHeld, worldFromHeld, [x, y, z]);
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
  mostMotion: number = SCHEDULE.reprojection.motion,
): Reprojection | null {
  if (current.key !== previous.key) return null;
  const room = reprojectionMatrix(current.clipFromWorld, previous.clipFromWorld);
  const motion = screenMotion(room, SCHEDULE.reprojection.distance);
  if (!(motion < mostMotion)) return null;
  return { room, held: reprojectionMatrix(current.clipFromHeld, previous.clipFromHeld), motion };
}

/**
 * Reprojection from one frame to another, of uv and depth, each 0 to 1.
 *
 * @param from clip space of the one, from world space
 * @param to of the other
 */
export function reprojectionMatrix(from: mat4, to: mat4): Float32Array {
  const worldFromClip = mat4.invert(mat4.create(), from)!;
  const between = mat4.multiply(mat4.create(), to, worldFromClip);
  mat4.multiply(between, PLACE_FROM_CLIP, between);
  return mat4.multiply(between, between, CLIP_FROM_PLACE) as Float32Array;
}

/** Motion of an image's corners under a reprojection, as a share of its size, for surfaces at a distance (m). */
export function screenMotion(between: mat4, distance: number): number {
  const depth = (FAR - (NEAR * FAR) / distance) / (FAR - NEAR);
  let most = 0;
  for (let corner = 0; corner < 4; corner++) {
    const [x, y] = [corner & 1, corner >> 1];
    const [u = 0, v = 0, , w = 0] = vec4.transformMat4([0, 0, 0, 0], [x, y, depth, 1], between);
    if (!(w > 0)) return Number.POSITIVE_INFINITY;
    most = Math.max(most, Math.abs(u / w - x), Math.abs(v / w - y));
  }
  return most;
}
