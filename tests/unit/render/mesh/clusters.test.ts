import { vec4 } from "gl-matrix";
import { expect, test } from "vitest";
import { type Part, PLAIN_MATERIAL } from "../../../../src/assets/model.ts";
import { frustumTest } from "../../../../src/render/camera.ts";
import {
  type Clusters,
  clusterSteps,
  groupTriangles,
  runsOf,
  VERTEX_SIZE,
} from "../../../../src/render/mesh/clusters.ts";
import { clipFromFace, FACES } from "../../../../src/render/shadow/cube-map.ts";
import type { Vec3 } from "../../../../src/world/geometry.ts";
import { finish } from "../../../../src/world/steps.ts";

/** A square of the floor, of many small triangles. */
function floor(cells: number, size: number, height = 0): Part {
  const positions: number[] = [];
  const uvs: number[] = [];
  const indices: number[] = [];
  for (let z = 0; z <= cells; z++) {
    for (let x = 0; x <= cells; x++) {
      positions.push((x / cells - 0.5) * size, height, (z / cells - 0.5) * size);
      uvs.push(x / cells, z / cells);
      if (x === cells || z === cells) continue;
      const corner = z * (cells + 1) + x;
      indices.push(corner, corner + 1, corner + cells + 1);
      indices.push(corner + 1, corner + cells + 2, corner + cells + 1);
    }
  }
  return {
    positions: Float32Array.from(positions),
    uvs: Float32Array.from(uvs),
    indices: Uint32Array.from(indices),
    material: PLAIN_MATERIAL,
  } as Part;
}

/** Area of all triangles seen from above, m². */
function area({ vertices, indices }: Clusters): number {
  let sum = 0;
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => {
      const at = (indices[i + k] ?? 0) * VERTEX_SIZE;
      return [vertices[at] ?? 0, vertices[at + 2] ?? 0] as const;
    });
    if (!a || !b || !c) continue;
    sum += Math.abs((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])) / 2;
  }
  return sum;
}

test("clusters hold every triangle once, within their boxes", () => {
  const parts = [floor(20, 4), floor(3, 1, 0.7)];
  const clusters = finish(clusterSteps(parts, 0));
  expect(clusters.indices.length).toBe(3 * (800 + 18));
  expect(area(clusters)).toBeCloseTo(16 + 1, 4);
  let next = 0;
  for (const { first, count, min, max } of clusters.clusters) {
    expect(first).toBe(next);
    next += count;
    for (const index of clusters.indices.subarray(first, first + count)) {
      for (const axis of [0, 1, 2] as const) {
        const x = clusters.vertices[index * VERTEX_SIZE + axis] ?? Number.NaN;
        expect(x).toBeGreaterThanOrEqual(min[axis]);
        expect(x).toBeLessThanOrEqual(max[axis]);
      }
    }
  }
  expect(next).toBe(clusters.indices.length);
});

test("what is melted has fewer triangles and covers the same floor", () => {
  const fine = finish(clusterSteps([floor(100, 4)], 0));
  const coarse = finish(clusterSteps([floor(100, 4)], 0.2));
  expect(coarse.indices.length).toBeLessThan(fine.indices.length / 10);
  expect(area(coarse)).toBeGreaterThan(0.85 * 16);
  expect(area(coarse)).toBeLessThanOrEqual(16);
});

test("a face of the cube leaves out only what does not show in it", () => {
  const eye: Vec3 = [0.3, 1, -0.2];
  const { clusters } = finish(clusterSteps([floor(40, 4)], 0));
  let drawn = 0;
  for (const face of FACES.keys()) {
    const clip = clipFromFace(face, eye);
    for (const box of clusters) {
      const centre = box.min.map((low, axis) => (low + (box.max[axis] ?? 0)) / 2);
      const [x = 0, y = 0, , w = 0] = vec4.transformMat4(
        vec4.create(),
        [...centre, 1] as never,
        clip,
      );
      const shows = w > 0 && Math.abs(x) <= w && Math.abs(y) <= w;
      if (shows) expect(frustumTest(clip)(box)).toBe(true);
      if (frustumTest(clip)(box)) drawn++;
    }
  }
  expect(drawn).toBeLessThan(3 * clusters.length);
});

test("parts with holes come last, and each vertex tells its part", () => {
  const perforated = { ...PLAIN_MATERIAL, alphaMode: "mask" } as const;
  const parts = [{ ...floor(20, 4), material: perforated }, floor(3, 1, 0.7)];
  const { clusters, indices, vertices, wholeCount } = finish(clusterSteps(parts, 0));
  expect(wholeCount).toBe(1);
  const partsIn = (some: typeof clusters) => [
    ...new Set(
      some.flatMap(({ first, count }) =>
        [...indices.subarray(first, first + count)].map((i) => vertices[i * VERTEX_SIZE + 5]),
      ),
    ),
  ];
  expect(partsIn(clusters.slice(0, wholeCount))).toEqual([1]);
  expect(partsIn(clusters.slice(wholeCount))).toEqual([0]);
});

test("neighbours in the order are drawn as one run", () => {
  const { clusters, indices } = finish(clusterSteps([floor(20, 4), floor(20, 4, 1)], 0));
  expect(runsOf(clusters, () => true)).toEqual([{ first: 0, count: indices.length }]);
  expect(runsOf(clusters, () => false)).toEqual([]);
});

test("of more runs than are drawn, those with the fewest hidden triangles between them are merged", () => {
  const { clusters } = finish(clusterSteps([floor(60, 4)], 0));
  const visible = new Set([0, 1, 3, 7, 9].map((i) => clusters[i]));
  const isVisible = (box: object) => visible.has(box as never);
  const at = (i: number) => clusters[i]?.first ?? Number.NaN;
  const run = (first: number, end: number) => ({ first: at(first), count: at(end) - at(first) });
  expect(runsOf(clusters, isVisible)).toEqual([run(0, 2), run(3, 4), run(7, 8), run(9, 10)]);
  expect(runsOf(clusters, isVisible, 2)).toEqual([run(0, 4), run(7, 10)]);
  expect(runsOf(clusters, isVisible, 1)).toEqual([run(0, 10)]);
});

test("clusters of all parts are in one order, and each vertex tells its part", () => {
  const { clusters, indices, vertices } = finish(
    clusterSteps([floor(40, 4), floor(40, 4, 0.1)], 0),
  );
  const parts = clusters.map(({ first }) => vertices[(indices[first] ?? 0) * VERTEX_SIZE + 5]);
  const changes = parts.filter((part, i) => i > 0 && part !== parts[i - 1]).length;
  expect(new Set(parts)).toEqual(new Set([0, 1]));
  expect(changes).toBeGreaterThan(2);
});

test("a part's own triangles are all there in groups, each within its box", () => {
  const part = { ...floor(20, 4, 0.3), indices: Uint16Array.from(floor(20, 4).indices) };
  const { indices, clusters, area } = groupTriangles(part);
  expect(indices).toBeInstanceOf(Uint16Array);
  expect(area).toBeCloseTo(16, 4);
  const triangles = (list: ArrayLike<number>) =>
    Array.from({ length: list.length / 3 }, (_, i) =>
      [0, 1, 2].map((k) => list[3 * i + k]).join(" "),
    ).sort();
  expect(triangles(indices)).toEqual(triangles(part.indices));
  expect(clusters.reduce((sum, { count }) => sum + count, 0)).toBe(indices.length);
  for (const { first, count, min, max } of clusters) {
    for (const index of indices.subarray(first, first + count)) {
      for (const axis of [0, 1, 2] as const) {
        const x = part.positions[index * 3 + axis] ?? Number.NaN;
        expect(x).toBeGreaterThanOrEqual(min[axis]);
        expect(x).toBeLessThanOrEqual(max[axis]);
      }
    }
  }
});

test("no triangle of many vertices is taken for another of the same key in 17 bits", () => {
  const base = 0x1ffff;
  const positions = new Float32Array(3 * (base + 10));
  for (let i = 0; i < base + 10; i++) positions.set([i % 1000, Math.floor(i / 1000), 0], i * 3);
  const indices = [0, 1, base + 5, 0, 2, 5];
  const uvs = new Float32Array(positions.length);
  const part = { positions, uvs, indices, material: PLAIN_MATERIAL } as unknown as Part;
  expect(finish(clusterSteps([part], 0.5)).indices.length).toBe(6);
});
