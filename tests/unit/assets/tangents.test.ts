import { expect, test } from "vitest";
import { replaceBadTangents } from "../../../src/assets/tangents.ts";

test("a tangent along the normal is replaced by one across it, and keeps the bitangent's sign", () => {
  const normals = Float32Array.of(1, 0, 0, 0, 1, 0, -1, 0, 0);
  const tangents = Float32Array.of(1, 0, 0, -1, 1, 0, 0, 1, 1, 1e-6, 0, 1);
  const [a, b, c, d, ...others] = replaceBadTangents(tangents, normals);
  expect([a, Math.hypot(b ?? 0, c ?? 0), d]).toEqual([0, 1, -1]);
  expect(others.slice(0, 4), "a good one stays").toEqual([1, 0, 0, 1]);
  expect(others[4]).toBeCloseTo(0);
});
