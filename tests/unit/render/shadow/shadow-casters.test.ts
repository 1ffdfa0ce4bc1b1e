import { expect, test } from "vitest";
import { type Material, type Model, PLAIN_MATERIAL } from "../../../../src/assets/model.ts";
import { clustersOf } from "../../../../src/render/shadow/shadow-casters.ts";
import { floorOf } from "../../world/rooms.ts";

/** Number of triangles that a square of a material stops light with. */
function casts(material: Partial<Material>): number {
  const part = { ...floorOf(1), uvs: new Float32Array(8) };
  const model = { parts: [{ ...part, material: { ...PLAIN_MATERIAL, ...material } }] };
  const task = clustersOf(model as unknown as Model, { error: 0.01 });
  return task.finish().indices.length / 3;
}

test("what is mixed or masked stops light where most of it is drawn: from half of the opacity on, or from the cutoff", () => {
  const blend = { alphaMode: "blend" } as const;
  const baseColor = [1, 1, 1, 0.3] as const;
  expect(casts({ ...blend, baseColor })).toBe(0);
  expect(casts({ ...blend, mapOpacity: 0.4 })).toBe(0);
  expect(casts(blend)).toBe(2);
  expect(casts({ alphaMode: "mask", baseColor, alphaCutoff: 0.25 })).toBe(2);
  expect(casts({ alphaMode: "mask", baseColor, alphaCutoff: 0.35 })).toBe(0);
  expect(casts({ baseColor })).toBe(2);
});
