import { readFileSync } from "node:fs";
import { vec3 } from "gl-matrix";
import { expect, test } from "vitest";
import { TAPER_NODES, UPRIGHT } from "../../../../src/render/volumetric/flame-pass.ts";
import { wickShape } from "../../../../src/render/volumetric/wick-shape.ts";
import type { Vec3 } from "../../../../src/world/geometry.ts";
import { openGlb } from "../../../../tools/models/glb-builder.mjs";

/** `WICK_RADIUS` of shaders/volumetric/flame.frag, metres. */
const RADIUS = 0.00105;

const wick = (...positions: number[]) => ({ positions: Float32Array.from(positions) });

/** Vertices of the taper's wick, and the root of its flame, metres. */
function taper(): { readonly root: Vec3; readonly positions: Float32Array } {
  const { json, binary } = openGlb(readFileSync("public/models/chamberstick.glb"));
  const mesh = json.meshes.find(({ name }: { name: string }) => name === "wick");
  const {
    bufferView,
    byteOffset = 0,
    count,
  } = json.accessors[mesh.primitives[0].attributes.POSITION];
  const bytes = Uint8Array.from(
    binary.subarray(json.bufferViews[bufferView].byteOffset + byteOffset),
  );
  const root = json.nodes.find(({ name }: { name: string }) => name === "flame").translation;
  return { root, positions: new Float32Array(bytes.buffer, 0, 3 * count) };
}

/** Least distance of a point to a line of pieces. */
function distanceTo(nodes: readonly Readonly<Vec3>[], point: Vec3): number {
  const distances = nodes.slice(1).map((to, i) => {
    const [piece, from] = [
      vec3.subtract(vec3.create(), to, nodes[i]!),
      vec3.subtract(vec3.create(), point, nodes[i]!),
    ];
    const share = Math.min(Math.max(vec3.dot(from, piece) / vec3.dot(piece, piece), 0), 1);
    return vec3.distance(from, vec3.scale(piece, piece, share));
  });
  return Math.min(...distances);
}

test.each([
  ["by its constants", 0.0004],
  ["by its mesh", 0.0007],
])("the taper's wick is drawn where its model has it, %s, to %d m", (by, most) => {
  const { root, positions } = taper();
  const nodes = by === "by its mesh" ? wickShape(root, [{ positions }]).nodes : TAPER_NODES;
  for (let at = 0; at < positions.length; at += 3) {
    const point = [0, 1, 2].map((axis) => positions[at + axis]! - root[axis]!) as Vec3;
    if (point[1] < 0) continue; // in the pool
    expect(distanceTo(nodes, point), `${point}`).toBeLessThan(RADIUS + most);
  }
});

test("a wick ends at its highest vertex near the flame's axis", () => {
  const wicks = [wick(0, 0.1, 0, 0, 0.109, 0.004), wick(0.05, 0.115, 0), wick(0, 0.2, 0)];
  expect(wickShape([0, 0.1, 0], wicks).end).toBeCloseTo(0.009, 6);
  const { end, nodes } = wickShape([0.05, 0.1, 0], wicks);
  expect(end).toBeCloseTo(0.015, 6);
  expect(nodes).toHaveLength(UPRIGHT.length);
  expect(nodes.flat().every(Number.isFinite)).toBe(true);
});

test("a flame without a wick has one that ends as a taper's does, upright", () => {
  for (const wicks of [[], [wick(0, 0.05, 0)]]) {
    expect(wickShape([0, 0.1, 0], wicks)).toEqual({ end: 0.0072, nodes: UPRIGHT });
  }
});
