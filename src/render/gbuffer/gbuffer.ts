import { mat4 } from "gl-matrix";
import type { Texture } from "../../gl/texture.js";
import type { Features } from "../../settings.js";
import { reprojectionMatrix, screenMotion } from "../camera.js";
import type { Surface } from "../mesh/mesh.js";

/** Where what a visitor looks at usually is, metres. */
const USUAL_DISTANCE = 2;
/** While the eye moves, paint is seen a second time if it shifts no farther, as a share of the picture. */
const MOST_SHIFT = 0.08;

/** The place of a model that stands where it was made. */
export const AT_ORIGIN = [0, 0, 0, 0] as const;

/** Surfaces, and where their model stands: x, y, z (m) and its turn about the vertical (rad). */
export interface Placed {
  readonly surfaces: readonly Surface[];
  readonly place: readonly [number, number, number, number];
  /** How far its surfaces may be from where they were while the eye moves, metres. */
  readonly slack: number;
  /** Whether it goes where the eye goes. */
  readonly isHeld?: boolean;
}

/** What shaders that include `lib/composite.glsl` are defined for, by the paint they are to light. */
const KIND_DEFINES = {
  /** As fine as the picture. */
  fine: { COARSE: 0, HISTORY: 0 },
  /** Of fewer pixels. */
  coarse: { COARSE: 1, HISTORY: 0 },
  /** The coarse one of the picture before. */
  kept: { COARSE: 1, HISTORY: 1 },
} as const;
export type GBufferKind = keyof typeof KIND_DEFINES;

export function forEachGBufferKind<T>(
  make: (defines: (typeof KIND_DEFINES)[GBufferKind]) => T,
): Readonly<Record<GBufferKind, T>> {
  return {
    fine: make(KIND_DEFINES.fine),
    coarse: make(KIND_DEFINES.coarse),
    kept: make(KIND_DEFINES.kept),
  };
}

/** From places in a picture to those in an earlier one: of the room, and of what goes where the eye goes. */
export interface Since {
  readonly room: mat4;
  readonly carried: mat4;
  /** How far the room is from where it was, as a share of the picture. */
  readonly shift: number;
}

/** What is seen, without its light. */
export interface Paint {
  readonly kind: GBufferKind;
  /** Root of the albedo as relief catches the light; alpha says where light is to be taken from. */
  readonly painted: Texture;
  /** How far away it is, for each pixel of the picture; of coarse paint whoever needs it draws it there. */
  readonly frameDepth: Texture;
  /** Of the samples: how the surface lies, roughness, what it is; depth. */
  readonly surfaces: Texture;
  readonly depth: Texture;
  /** Which of them each texel of the light is worked out at; null for coarse paint. */
  readonly usual: Texture | null;
  /** All that it depends on. */
  readonly known: string;
  /** From places in the picture to those in the one that it was painted for; null if it is the same. */
  readonly since: Since | null;
}

/** Paint that may be seen a second time. */
export interface Kept {
  readonly clip: mat4;
  /** Of what the eye carries: its clip space then, from its own. */
  readonly carried: mat4;
  /** All that must be the same. */
  readonly known: string;
}

export function historyOf(placed: readonly Placed[], clip: mat4, features: Features): Kept {
  const standing = placed.map(({ place, isHeld }) => isHeld || place);
  const carried = placed.find(({ isHeld }) => isHeld)?.place ?? AT_ORIGIN;
  const worldFromModel = mat4.fromTranslation(mat4.create(), [carried[0], carried[1], carried[2]]);
  mat4.rotateY(worldFromModel, worldFromModel, carried[3]);
  return {
    clip,
    carried: mat4.multiply(worldFromModel, clip, worldFromModel),
    known: JSON.stringify([standing, features]),
  };
}

/** Where all of a picture was in the one before; null if that is too far, or other things were seen there. */
export function reprojectionBetween(now: Kept, before: Kept): Since | null {
  if (now.known !== before.known) return null;
  const room = reprojectionMatrix(now.clip, before.clip);
  const shift = screenMotion(room, USUAL_DISTANCE);
  if (!(shift < MOST_SHIFT)) return null;
  return { room, carried: reprojectionMatrix(now.carried, before.carried), shift };
}
