import { expect, test } from "vitest";
import { type Simplifiable, Simplification } from "../../../../src/render/mesh/simplify.ts";
import { thicknessesOf } from "../../../../src/render/mesh/thickness.ts";

type Vec = readonly [number, number, number];

/** A tube of so many sides and rings, its seam split as its picture's edge splits it; open at both ends. */
function tube(sides: number, rings: number, radius: number, length: number): Simplifiable {
  const positions: number[] = [];
  const normals: number[] = [];
  const indices: number[] = [];
  for (let ring = 0; ring <= rings; ring++) {
    for (let side = 0; side <= sides; side++) {
      const angle = (2 * Math.PI * (side % sides)) / sides;
      const [c, s] = [Math.cos(angle), Math.sin(angle)];
      positions.push(radius * c, (length * ring) / rings, radius * s);
      normals.push(c, 0, s);
      if (ring === rings || side === sides) continue;
      const at = ring * (sides + 1) + side;
      indices.push(at, at + sides + 1, at + 1, at + 1, at + sides + 1, at + sides + 2);
    }
  }
  return { positions: Float32Array.from(positions), normals, indices };
}

/** The vertices of the mesh at which the corners are. */
function simplified(mesh: Simplifiable, error: number): Uint32Array {
  const work = new Simplification(mesh, error);
  while (work.proceed());
  const { places, indices } = work.result;
  expect(indices.length).toBe(work.length);
  return indices.map((vertex) => places[vertex]!);
}

function thicknessOf({ positions, indices }: Simplifiable): number {
  return thicknessesOf(positions, indices)[0] ?? 0;
}

const place = ({ positions }: Simplifiable, vertex: number): Vec => [
  positions[3 * vertex] ?? 0,
  positions[3 * vertex + 1] ?? 0,
  positions[3 * vertex + 2] ?? 0,
];

/** Directed edges between places, and how often each is there. */
function edges(mesh: Simplifiable, indices: ArrayLike<number>): Map<string, number> {
  const counts = new Map<string, number>();
  for (let i = 0; i < indices.length; i += 3) {
    for (let k = 0; k < 3; k++) {
      const from = place(mesh, indices[i + k] ?? 0);
      const to = place(mesh, indices[i + ((k + 1) % 3)] ?? 0);
      const key = `${from} > ${to}`;
      counts.set(key, (counts.get(key) ?? 0) + 1);
    }
  }
  return counts;
}

/** Edges with a triangle on one side only. */
function rim(mesh: Simplifiable, indices: ArrayLike<number>): string[] {
  const all = edges(mesh, indices);
  return [...all.keys()].filter((key) => !all.has(key.split(" > ").reverse().join(" > ")));
}

test("A tube keeps its shape with a tenth of its triangles, and no crack opens along its seam", () => {
  const mesh = tube(48, 40, 0.1, 2);
  const indices = simplified(mesh, 0.004);
  expect(indices.length).toBeLessThan(mesh.indices.length / 10);
  expect(indices.length).toBeGreaterThan(3 * 8);
  for (let i = 0; i < indices.length; i += 3) {
    const corners = [0, 1, 2].map((k) => place(mesh, indices[i + k] ?? 0));
    const middle = [0, 2].map((axis) => corners.reduce((sum, p) => sum + (p[axis] ?? 0) / 3, 0));
    const apart = 0.1 - Math.hypot(...middle);
    expect(apart).toBeGreaterThan(-1e-6);
    expect(apart).toBeLessThan(0.02);
  }
  // Both rims, and nothing else, have one side; each edge is walked once each way.
  for (const key of rim(mesh, indices)) {
    const heights = key.split(" > ").map((end) => Number(end.split(",")[1]));
    expect(new Set(heights).size).toBe(1);
    expect([0, 2]).toContain(heights[0]);
  }
  for (const count of edges(mesh, indices).values()) expect(count).toBe(1);
});

test("What is flat falls together wholly, but keeps its outline; what is needed stays", () => {
  const cells = 20;
  const positions: number[] = [];
  const normals: number[] = [];
  const indices: number[] = [];
  for (let z = 0; z <= cells; z++) {
    for (let x = 0; x <= cells; x++) {
      positions.push(x / cells, 0, z / cells);
      normals.push(0, 1, 0);
      if (x === cells || z === cells) continue;
      const at = z * (cells + 1) + x;
      indices.push(at, at + cells + 1, at + 1, at + 1, at + cells + 1, at + cells + 2);
    }
  }
  const mesh = { positions: Float32Array.from(positions), normals, indices };
  const flat = simplified(mesh, 0.001);
  expect(flat.length).toBeLessThan(3 * 40);
  let area = 0;
  for (let i = 0; i < flat.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => place(mesh, flat[i + k] ?? 0)) as [Vec, Vec, Vec];
    const twice = (b[2] - a[2]) * (c[0] - a[0]) - (b[0] - a[0]) * (c[2] - a[2]);
    expect(twice).toBeGreaterThan(0);
    area += twice / 2;
  }
  expect(area).toBeCloseTo(1, 5);
  const few = { positions: [0, 0, 0, 1, 0, 0, 0, 0, 1], normals: [0, 1, 0, 0, 1, 0, 0, 1, 0] };
  expect([...simplified({ ...few, indices: [0, 2, 1] }, 0.001)]).toEqual([0, 2, 1]);
  expect([...simplified({ ...few, indices: [] }, 0.001)]).toEqual([]);
});

test("A surface that is open has no thickness; of a closed one it is known, and its sides keep apart", () => {
  expect(thicknessOf(tube(8, 2, 0.1, 1))).toBeLessThan(0.2); // open at its ends, which weigh each other up
  const square = {
    positions: [0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 1],
    normals: [],
    indices: [0, 2, 1, 1, 2, 3],
  };
  expect(thicknessOf(square)).toBe(Number.POSITIVE_INFINITY);
  // A wavy cloth of 4 mm: a closed skin, of as many squares all around as along.
  const around = 80;
  const along = 40;
  const positions: number[] = [];
  const normals: number[] = [];
  const indices: number[] = [];
  for (let row = 0; row <= along; row++) {
    for (let side = 0; side < around; side++) {
      const isUp = side < around / 2;
      const x = isUp ? side : around - 1 - side;
      positions.push(x / 40, 0.03 * Math.sin(x / 3) + (isUp ? 0.004 : 0), row / along);
      normals.push(0, isUp ? 1 : -1, 0);
      if (row === along) continue;
      const at = (r: number, s: number) => (row + r) * around + ((side + s) % around);
      indices.push(at(0, 0), at(1, 0), at(0, 1), at(0, 1), at(1, 0), at(1, 1));
    }
  }
  const cloth = { positions: Float32Array.from(positions), normals, indices };
  expect(thicknessOf(cloth)).toBeGreaterThan(0.002);
  expect(thicknessOf(cloth)).toBeLessThan(0.0041);
  const few = simplified(cloth, 0.02);
  expect(few.length).toBeLessThan(indices.length / 3);
  for (const vertex of few) expect(vertex).toBeLessThan(positions.length / 3);
  // The waves are there, on either side.
  const columns = new Set(Array.from(few, (vertex) => vertex % around));
  expect(columns.size).toBeGreaterThan(16);
});

/** A cube whose edges are cut off, every face lit as if it were flat. */
function bevelledCube(size: number, bevel: number): Simplifiable {
  const positions: number[] = [];
  const normals: number[] = [];
  const indices: number[] = [];
  /** Corners counter-clockwise as seen from where the normal points. */
  const face = (normal: Vec, ...corners: readonly Vec[]) => {
    const first = positions.length / 3;
    const [a, b, c] = corners as readonly [Vec, Vec, Vec];
    const [u, v] = [b, c].map((to) => to.map((x, k) => x - a[k]!)) as [number[], number[]];
    const facing = [0, 1, 2].reduce(
      (sum, k) =>
        sum + normal[k]! * (u[(k + 1) % 3]! * v[(k + 2) % 3]! - u[(k + 2) % 3]! * v[(k + 1) % 3]!),
      0,
    );
    for (const corner of corners) {
      positions.push(...corner);
      normals.push(...normal.map((x) => x / Math.hypot(...normal)));
    }
    for (let k = 2; k < corners.length; k++) {
      indices.push(
        first,
        ...(facing > 0 ? [first + k - 1, first + k] : [first + k, first + k - 1]),
      );
    }
  };
  const [far, near] = [size / 2, size / 2 - bevel];
  const at = (axis: number, main: number, one: number, other: number): Vec => {
    const place = [0, 0, 0];
    place[axis] = main;
    place[(axis + 1) % 3] = one;
    place[(axis + 2) % 3] = other;
    return place as unknown as Vec;
  };
  for (const axis of [0, 1, 2]) {
    for (const s of [-1, 1]) {
      face(
        at(axis, s, 0, 0),
        ...[
          [-1, -1],
          [1, -1],
          [1, 1],
          [-1, 1],
        ].map(([a, b]) => at(axis, s * far, a! * near, b! * near)),
      );
      for (const t of [-1, 1]) {
        face(
          at(axis, 0, s, t),
          at(axis, -near, s * far, t * near),
          at(axis, near, s * far, t * near),
          at(axis, near, s * near, t * far),
          at(axis, -near, s * near, t * far),
        );
      }
    }
  }
  for (const x of [-1, 1]) {
    for (const y of [-1, 1]) {
      for (const z of [-1, 1]) {
        face(
          [x, y, z],
          [x * far, y * near, z * near],
          [x * near, y * far, z * near],
          [x * near, y * near, z * far],
        );
      }
    }
  }
  return { positions, normals, indices };
}

test("Of a box whose edges are bevelled a plain box is left, each face as it looked", () => {
  const mesh = bevelledCube(0.2, 0.004);
  expect(mesh.indices.length).toBe(3 * 44);
  const work = new Simplification(mesh, 0.006);
  while (work.proceed());
  const { places, looks, indices } = work.result;
  expect(indices.length).toBe(3 * 12);
  expect(new Set(places).size).toBe(8);
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => place(mesh, places[indices[i + k]!]!)) as [
      Vec,
      Vec,
      Vec,
    ];
    const facing = [0, 1, 2].map((k) => {
      const [m, n] = [(k + 1) % 3, (k + 2) % 3];
      return (b[m]! - a[m]!) * (c[n]! - a[n]!) - (b[n]! - a[n]!) * (c[m]! - a[m]!);
    });
    // What it is lit as and what it is differ by no more than the bevel was wide.
    for (const corner of [0, 1, 2]) {
      const look = looks[indices[i + corner]!]!;
      const along = facing.reduce((sum, x, k) => sum + x * mesh.normals[3 * look + k]!, 0);
      expect(along / Math.hypot(...facing)).toBeGreaterThan(0.99);
    }
  }
  // A finer eye keeps it.
  expect(simplified(mesh, 0.001).length).toBe(mesh.indices.length);
});
