import { expect, test } from "vitest";
import type { Part } from "../../../../src/assets/model.ts";
import type { Mesh } from "../../../../src/render/mesh/mesh.ts";
import { hasLods, reducedPart } from "../../../../src/render/mesh/mesh-lods.ts";

/** Five vertices in a row, a triangle for each three that follow each other. */
function row(reducedIndices?: readonly number[]): Mesh {
  const numbers = (size: number) => Float32Array.from({ length: 5 * size }, (_, i) => i);
  const part = {
    positions: numbers(3),
    normals: numbers(3),
    tangents: numbers(4),
    uvs: numbers(2),
    colors: null,
    indices: Uint16Array.of(0, 1, 2, 1, 2, 3, 2, 3, 4),
    ...(reducedIndices && { reducedIndices: Uint32Array.from(reducedIndices) }),
  };
  return { part: part as unknown as Part } as Mesh;
}

test("A lower level of detail has its own triangles and no vertex that they do not use", () => {
  const low = reducedPart([row([4, 0, 2]).part]);
  expect([...low.indices]).toEqual([0, 1, 2]);
  expect([...low.positions]).toEqual([12, 13, 14, 0, 1, 2, 6, 7, 8]);
  expect([...low.uvs]).toEqual([8, 9, 0, 1, 4, 5]);
  expect([...(low.colors ?? [])]).toEqual(Array(12).fill(1));
  // What has no lower level, beside something that has one, is whole.
  const both = reducedPart([row([4, 0, 2]).part, row().part]);
  expect([...both.indices]).toEqual([0, 1, 2, 3, 4, 5, 4, 5, 6, 5, 6, 7]);
  expect(both.positions).toHaveLength(24);
});

test("A model that brings no lower level has none", () => {
  expect(hasLods([row(), row()])).toBe(false);
  expect(hasLods([row([4, 0, 2]), row()])).toBe(true);
});
