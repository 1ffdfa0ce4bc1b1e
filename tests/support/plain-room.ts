import { packGlb } from "../../tools/models/glb-builder.mjs";

type Corner = readonly [number, number, number];

/** Opposite corners, metres. */
export interface Box {
  readonly min: Corner;
  readonly max: Corner;
}

/** Corners of a box's six faces as seen from outside, counter-clockwise: 0 is min, 1 is max. */
const FACES = [0, 1, 2].flatMap((axis) =>
  [0, 1].map((side) => {
    const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
    const round = [
      [0, 0],
      [1, 0],
      [1, 1],
      [0, 1],
    ];
    const corners = (side === 1 ? round : round.toReversed()).map(([a, b]) => {
      const corner = [0, 0, 0];
      corner[axis] = side;
      corner[u] = a ?? 0;
      corner[v] = b ?? 0;
      return corner;
    });
    const normal = [0, 0, 0];
    normal[axis] = side === 1 ? 1 : -1;
    return { corners, normal };
  }),
);

/** A node without a mesh. */
export interface PlainNode {
  readonly name: string;
  readonly translation?: readonly (number | null)[];
  readonly rotation?: readonly number[];
  readonly scale?: readonly number[];
  readonly extras?: unknown;
}

/** A box-shaped room with boxes in it, all of them matt and of one reflectance, and more nodes, as a .glb. */
export function plainRoom(
  room: Box,
  boxes: readonly Box[],
  albedo: number,
  nodes: readonly PlainNode[] = [],
): Buffer {
  const positions: number[] = [];
  const normals: number[] = [];
  const indices: number[] = [];
  for (const box of [room, ...boxes]) {
    const inward = box === room;
    for (const { corners, normal } of FACES) {
      const first = positions.length / 3;
      for (const corner of corners) {
        positions.push(...corner.map((end, axis) => (end ? box.max : box.min)[axis] ?? 0));
        normals.push(...normal.map((x) => (inward ? -x : x)));
      }
      const order = inward ? [0, 2, 1, 0, 3, 2] : [0, 1, 2, 0, 2, 3];
      indices.push(...order.map((i) => first + i));
    }
  }
  const floats = Buffer.from(Float32Array.from([...positions, ...normals]).buffer);
  const numbers = Buffer.from(Uint32Array.from(indices).buffer);
  const count = positions.length / 3;
  const half = floats.length / 2;
  const material = {
    pbrMetallicRoughness: {
      baseColorFactor: [albedo, albedo, albedo, 1],
      roughnessFactor: 1,
      metallicFactor: 0,
    },
  };
  const json = {
    asset: { version: "2.0" },
    scene: 0,
    scenes: [{ nodes: [0, ...nodes.map((_, i) => i + 1)] }],
    nodes: [{ mesh: 0 }, ...nodes],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, NORMAL: 1 }, indices: 2, material: 0 }] }],
    materials: [material],
    buffers: [{ byteLength: floats.length + numbers.length }],
    bufferViews: [
      { buffer: 0, byteOffset: 0, byteLength: half },
      { buffer: 0, byteOffset: half, byteLength: half },
      { buffer: 0, byteOffset: floats.length, byteLength: numbers.length },
    ],
    accessors: [
      {
        bufferView: 0,
        componentType: 5126,
        count,
        type: "VEC3",
        min: room.min,
        max: room.max,
      },
      { bufferView: 1, componentType: 5126, count, type: "VEC3" },
      { bufferView: 2, componentType: 5125, count: indices.length, type: "SCALAR" },
    ],
  };
  return packGlb(json, Buffer.concat([floats, numbers]));
}
