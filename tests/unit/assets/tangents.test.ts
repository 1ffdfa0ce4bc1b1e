import { BufferAttribute, BufferGeometry, Mesh } from "three";
import { expect, test } from "vitest";
import { type Part, PLAIN_MATERIAL } from "../../../src/assets/model.ts";
import { readPart } from "../../../src/assets/read-part.ts";
import { replaceBadTangents } from "../../../src/assets/tangents.ts";
import { UNTURNED } from "../../../src/assets/texture-placement.ts";

test("a tangent along the normal is replaced by one across it, and keeps the bitangent's sign", () => {
  const normals = Float32Array.of(1, 0, 0, 0, 1, 0, -1, 0, 0);
  const tangents = Float32Array.of(1, 0, 0, -1, 1, 0, 0, 1, 1, 1e-6, 0, 1);
  const [a, b, c, d, ...others] = replaceBadTangents(tangents, normals);
  expect([a, Math.hypot(b ?? 0, c ?? 0), d]).toEqual([0, 1, -1]);
  expect(others.slice(0, 4), "a good one stays").toEqual([1, 0, 0, 1]);
  expect(others[4]).toBeCloseTo(0);
});

test("where mirrored images meet, each side has vertices and frames of its own", () => {
  // Two squares side by side: u runs up to the seam between them, and back.
  const positions = [-1, 0, 1].flatMap((x) => [x, 0, 0, x, 1, 0]);
  const [whole, half] = [
    [0, 2, 1, 1, 2, 3, 2, 4, 3, 3, 4, 5],
    [0, 2, 1, 1, 2, 3],
  ].map((indices) => {
    const attribute = (values: number[], size: number) =>
      new BufferAttribute(Float32Array.from(values), size);
    const geometry = new BufferGeometry()
      .setAttribute("position", attribute(positions, 3))
      .setAttribute(
        "normal",
        attribute(
          positions.map((_, i) => Number(i % 3 === 2)),
          3,
        ),
      )
      .setAttribute(
        "uv",
        attribute(
          [0, 1, 0].flatMap((u) => [u, 1, u, 0]),
          2,
        ),
      )
      .setIndex(indices);
    const normal = { width: 1, height: 1, data: new Uint8Array(4) };
    const material = { ...PLAIN_MATERIAL, normal };
    return readPart(new Mesh(geometry), "squares", { material, placement: UNTURNED })!;
  }) as [Part, Part];
  const place = (vertex: number) => [...whole.positions.subarray(vertex * 3, vertex * 3 + 3)];
  const corners = [0, 2, 1, 1, 2, 3, 2, 4, 3, 3, 4, 5];
  expect([...whole.indices].map(place), "the same triangles").toEqual(
    corners.map((i) => positions.slice(i * 3, i * 3 + 3)),
  );
  for (const [i, vertex] of [...whole.indices].entries()) {
    const side = i < 6 ? 1 : -1;
    expect([...whole.tangents.subarray(vertex * 4, vertex * 4 + 4)]).toEqual([side, 0, 0, side]);
    expect([...whole.uvs.subarray(vertex * 2, vertex * 2 + 2)]).toEqual([
      Number(place(vertex)[0] === 0),
      1 - place(vertex)[1]!,
    ]);
  }
  expect(whole.positions).toHaveLength(8 * 3);
  expect(half.positions, "nothing to split").toHaveLength(4 * 3);
});
