import { roomModel } from "../../tools/reference/rooms.mjs";

type Corner = readonly [number, number, number];

/** Opposite corners, metres. */
export interface Box {
  readonly min: Corner;
  readonly max: Corner;
}

/** A node without a mesh. */
export interface PlainNode {
  readonly name: string;
  readonly translation?: readonly (number | null)[];
  readonly rotation?: readonly number[];
  readonly scale?: readonly number[];
  readonly extras?: unknown;
}

/** For tests of what does not depend on the room: the cabin takes a processor twice as long to open. */
export const QUICK_ROOM = plainRoom({ min: [-2, 0, -2], max: [2, 2.6, 2] }, [], 0.5);

/** A box-shaped room with boxes in it, all of them matt and of one reflectance, and more nodes, as a .glb. */
export function plainRoom(
  room: Box,
  boxes: readonly Box[],
  albedo: number,
  nodes: readonly PlainNode[] = [],
): Buffer {
  const material = { color: [albedo, albedo, albedo], roughness: 1 } as const;
  const shell = { ...room, material, isShell: true };
  return roomModel([shell, ...boxes.map((box) => ({ ...box, material }))], nodes);
}
