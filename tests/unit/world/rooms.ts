import { existsSync, readFileSync } from "node:fs";
import { resolve } from "node:path";
import type { Bounds, Vec3 } from "../../../src/world/geometry.ts";
import type { Triangles } from "../../../src/world/room/collision-mesh.ts";
import { chance } from "../chance.ts";

/** A room to walk in, and the box that the walker's whole circle must stay in. */
export interface Room {
  readonly parts: readonly Triangles[];
  readonly spawn: Vec3 | null;
  readonly inside: Bounds;
}

/** Two triangles, counter-clockwise as given. */
export function quad(a: Vec3, b: Vec3, c: Vec3, d: Vec3): Triangles {
  return {
    positions: new Float32Array([...a, ...b, ...c, ...d]),
    indices: new Uint16Array([0, 1, 2, 0, 2, 3]),
  };
}

/** A level square, metres, facing up. */
export function floorOf(size: number, y = 0): Triangles {
  const half = size / 2;
  return quad([-half, y, half], [half, y, half], [half, y, -half], [-half, y, -half]);
}

/** The six faces of a box, seen from outside; turned about the vertical through its middle. */
export function box(min: Vec3, max: Vec3, turn = 0): Triangles {
  const [cx, cz] = [(min[0] + max[0]) / 2, (min[2] + max[2]) / 2];
  const positions: number[] = [];
  for (let i = 0; i < 8; i++) {
    const x = (i & 1 ? max[0] : min[0]) - cx;
    const z = (i & 4 ? max[2] : min[2]) - cz;
    positions.push(
      cx + x * Math.cos(turn) + z * Math.sin(turn),
      i & 2 ? max[1] : min[1],
      cz - x * Math.sin(turn) + z * Math.cos(turn),
    );
  }
  return {
    positions: new Float32Array(positions),
    indices: new Uint16Array([
      0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1,
      3, 5, 3, 7, 5,
    ]),
  };
}

/** The same faces, seen from inside. */
export function insideOf(min: Vec3, max: Vec3): Triangles {
  const { positions, indices } = box(min, max);
  return { positions, indices: indices.toReversed() };
}

/** A table of 1.2 x 0.7 m, 0.75 m high, with four legs. */
export function table(x: number, z: number): Triangles[] {
  const legs = [-1, 1].flatMap((i) =>
    [-1, 1].map((j) => {
      const [lx, lz] = [x + i * 0.55, z + j * 0.3];
      return box([lx - 0.03, 0, lz - 0.03], [lx + 0.03, 0.72, lz + 0.03]);
    }),
  );
  return [box([x - 0.6, 0.72, z - 0.35], [x + 0.6, 0.75, z + 0.35]), ...legs];
}

/** A sphere of 2 n² triangles. */
export function sphere([x, y, z]: Vec3, radius: number, n: number): Triangles {
  const positions: number[] = [];
  const indices: number[] = [];
  for (let j = 0; j <= n; j++) {
    for (let i = 0; i <= n; i++) {
      const [a, b] = [(2 * Math.PI * i) / n, (Math.PI * j) / n];
      positions.push(
        x + radius * Math.sin(b) * Math.cos(a),
        y + radius * Math.cos(b),
        z + radius * Math.sin(b) * Math.sin(a),
      );
      const at = j * (n + 1) + i;
      if (i < n && j < n) indices.push(at, at + 1, at + n + 1, at + 1, at + n + 2, at + n + 1);
    }
  }
  return { positions: new Float32Array(positions), indices: new Uint32Array(indices) };
}

export const PLAIN: Room = {
  parts: [insideOf([-2.5, 0, -2], [2.5, 2.6, 2])],
  spawn: [0, 0, 1],
  inside: { min: [-2.5, 0, -2], max: [2.5, 2.6, 2] },
};

/** Legs, boxes, walls of 2 cm, diagonal ones, a gap of 0.6 m, and corners of all kinds. */
export const FURNISHED: Room = {
  parts: [
    insideOf([-4, 0, -3], [4, 2.6, 3]),
    ...table(-2.4, -1.6),
    // A screen across the room, with a gap of 0.6 m.
    box([1, 0, -3], [1.02, 2.6, -0.3]),
    box([1, 0, 0.3], [1.02, 2.6, 3]),
    // One triangle thick, on the bias.
    quad([-3.9, 0, 1], [-2.2, 0, 2.9], [-2.2, 2.2, 2.9], [-3.9, 2.2, 1]),
    box([2, 0, -2.4], [3.2, 0.9, -1.7], 0.6),
    box([-0.6, 0, 1.2], [0, 0.45, 1.8], 1.1),
    // A pocket that narrows to nothing.
    box([2.2, 0, 0.6], [3.8, 2, 0.62], 0.5),
    box([2.2, 0, 1.4], [3.8, 2, 1.42], -0.35),
    // A shelf one bumps the head on, and a sill that one steps over.
    box([-0.8, 1.5, -3], [0.6, 1.54, -2.6]),
    box([-1.4, 0, -0.9], [-1.2, 0.08, 0.8]),
  ],
  spawn: [-1, 0, 0],
  inside: { min: [-4, 0, -3], max: [4, 2.6, 3] },
};

/** A room of about so many triangles: a floor full of balls. */
export function crowdedRoom(size: number, triangles: number): readonly Triangles[] {
  const between = chance(11);
  const half = size / 2;
  const n = Math.round(Math.sqrt(triangles / 40));
  return [
    insideOf([-half, 0, -half], [half, 2.6, half]),
    ...Array.from({ length: 20 }, () =>
      sphere([between(-0.4, 0.4) * size, 0.6, between(-0.4, 0.4) * size], 0.4, n),
    ),
  ];
}

interface Gltf {
  readonly nodes: readonly {
    readonly name?: string;
    readonly mesh?: number;
    readonly children?: readonly number[];
    readonly translation?: Vec3;
    readonly rotation?: readonly number[];
    readonly scale?: Vec3;
    readonly matrix?: readonly number[];
  }[];
  readonly meshes: readonly {
    readonly primitives: readonly { attributes: { POSITION: number }; indices: number }[];
  }[];
  readonly accessors: readonly {
    bufferView: number;
    byteOffset?: number;
    componentType: number;
    count: number;
  }[];
  readonly bufferViews: readonly { byteOffset?: number; byteStride?: number }[];
}

interface ModelRoom {
  readonly parts: Triangles[];
  readonly spawn: Vec3 | null;
  readonly wicks: readonly { readonly name: string; readonly position: Vec3 }[];
}

/** Triangles of one of our own models, its spawn point and its wicks; null if it is not there. */
export function modelRoom(name: string): ModelRoom | null {
  const path = resolve(import.meta.dirname, "../../../public/models", name);
  if (!existsSync(path)) return null;
  const file = readFileSync(path);
  const jsonLength = file.readUInt32LE(12);
  const gltf = JSON.parse(file.toString("utf8", 20, 20 + jsonLength)) as Gltf;
  const binary = file.subarray(28 + jsonLength);
  const read = (index: number, components: number): number[] => {
    const accessor = gltf.accessors[index]!;
    const view = gltf.bufferViews[accessor.bufferView]!;
    const bytes = { 5123: 2, 5125: 4, 5126: 4 }[accessor.componentType]!;
    const stride = view.byteStride ?? bytes * components;
    const start = (view.byteOffset ?? 0) + (accessor.byteOffset ?? 0);
    return Array.from({ length: accessor.count * components }, (_, i) => {
      const at = start + Math.floor(i / components) * stride + (i % components) * bytes;
      if (accessor.componentType === 5126) return binary.readFloatLE(at);
      return bytes === 2 ? binary.readUInt16LE(at) : binary.readUInt32LE(at);
    });
  };
  // Ours bake their transforms, but for that of nodes without geometry.
  for (const node of gltf.nodes) {
    if (node.mesh !== undefined && (node.translation || node.rotation || node.scale || node.matrix))
      throw new Error(`${node.name} is not where its vertices are.`);
  }
  return {
    parts: gltf.meshes.flatMap(({ primitives }) =>
      primitives.map(({ attributes, indices }) => ({
        positions: new Float32Array(read(attributes.POSITION, 3)),
        indices: new Uint32Array(read(indices, 1)),
      })),
    ),
    spawn: gltf.nodes.find(({ name }) => name === "spawn")?.translation ?? null,
    wicks: gltf.nodes.flatMap(({ name = "", translation }) =>
      name.startsWith("wick") && translation ? [{ name, position: translation }] : [],
    ),
  };
}

/** Squares that polygons are sorted into, and how far beyond them one may be asked for, metres. */
const SQUARE = 0.25;
const FAR = 0.4;

interface Outline {
  /** xz */
  readonly corners: Float64Array;
  readonly min: readonly [number, number];
  readonly max: readonly [number, number];
}

/** Triangles cut off at two heights and seen from above: the truth, without any tree or field. */
export class Rubble {
  readonly #squares = new Map<number, Outline[]>();

  constructor(parts: readonly Triangles[], low: number, high: number) {
    for (const { positions, indices } of parts) {
      for (let i = 0; i < indices.length; i += 3) {
        const corners = [0, 1, 2].map(
          (k) => [...positions.subarray(indices[i + k]! * 3, indices[i + k]! * 3 + 3)] as Vec3,
        );
        const polygon = cutOff(cutOff(corners, 1, low), -1, high);
        if (polygon.length > 0) this.#add(polygon);
      }
    }
  }

  #add(polygon: readonly Vec3[]): void {
    const [x, z] = [polygon.map((p) => p[0]), polygon.map((p) => p[2])];
    const outline: Outline = {
      corners: Float64Array.from(polygon.flatMap((p) => [p[0], p[2]])),
      min: [Math.min(...x), Math.min(...z)],
      max: [Math.max(...x), Math.max(...z)],
    };
    const square = (value: number) => Math.floor(value / SQUARE);
    for (let i = square(outline.min[0] - FAR); i <= square(outline.max[0] + FAR); i++) {
      for (let j = square(outline.min[1] - FAR); j <= square(outline.max[1] + FAR); j++) {
        const outlines = this.#squares.get(i * 65536 + j);
        if (outlines) outlines.push(outline);
        else this.#squares.set(i * 65536 + j, [outline]);
      }
    }
  }

  /** Distance from an upright axis to the nearest; 0 inside of one; at most `FAR`. */
  distance(x: number, z: number): number {
    let least = FAR * FAR;
    const square = Math.floor(x / SQUARE) * 65536 + Math.floor(z / SQUARE);
    for (const { corners, min, max } of this.#squares.get(square) ?? []) {
      const besideX = Math.max(min[0] - x, x - max[0], 0);
      const besideZ = Math.max(min[1] - z, z - max[1], 0);
      if (besideX * besideX + besideZ * besideZ >= least) continue;
      let turns = 0;
      for (let i = 0; i < corners.length; i += 2) {
        const next = (i + 2) % corners.length;
        const [ax, az] = [corners[i]!, corners[i + 1]!];
        const [ex, ez] = [corners[next]! - ax, corners[next + 1]! - az];
        const [px, pz] = [x - ax, z - az];
        const t = Math.min(1, Math.max(0, (px * ex + pz * ez) / (ex * ex + ez * ez || 1)));
        least = Math.min(least, (px - ex * t) ** 2 + (pz - ez * t) ** 2);
        // Winding number: how often the outline goes around the point.
        if (pz >= 0 !== pz >= ez && ex * pz - ez * px > 0 === ez > 0) turns += ez > 0 ? 1 : -1;
      }
      if (turns !== 0) return 0;
    }
    return Math.sqrt(least);
  }
}

/** What of a polygon lies above a height (`side` 1) or below it (-1). */
function cutOff(polygon: readonly Vec3[], side: number, height: number): Vec3[] {
  return polygon.flatMap((a, i): Vec3[] => {
    const b = polygon[(i + 1) % polygon.length]!;
    const [above, next] = [(a[1] - height) * side, (b[1] - height) * side];
    const t = above / (above - next);
    const cut: Vec3 = [a[0] + (b[0] - a[0]) * t, height, a[2] + (b[2] - a[2]) * t];
    if (above >= 0) return next >= 0 ? [a] : [a, cut];
    return next > 0 ? [cut] : [];
  });
}
