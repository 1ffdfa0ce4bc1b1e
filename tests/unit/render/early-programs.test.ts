import { expect, test } from "vitest";
import type { Gpu } from "../../../src/gl/gpu.ts";
import { FlameShadows } from "../../../src/render/lone-candle/flame-shadows.ts";
import { SummedSurfaces } from "../../../src/render/lone-candle/summed-surfaces.ts";
import type { Mesh } from "../../../src/render/mesh/mesh.ts";

test("Programs of a model's surfaces, whole and cut out, are requested before any is drawn", () => {
  const requested: string[] = [];
  const program = (label: string, _vertex: unknown, _fragment: unknown, options = {}) =>
    requested.push(`${label} ${JSON.stringify(options)}`);
  const gpu = { program, pass() {}, renderTarget() {} } as unknown as Gpu;
  const mesh = (isCutOut: boolean) =>
    ({ isCutOut, uniforms: { uSurface: [0, 0, 0, isCutOut ? 0.5 : 0] } }) as unknown as Mesh;
  const meshes = [mesh(false), mesh(true)];
  new FlameShadows(gpu, 1, 128).request(meshes);
  new SummedSurfaces(gpu, 1, meshes, () => {});
  expect(requested).toEqual([
    'candle/custom-shadow {"defines":{}}',
    'candle/custom-shadow {"defines":{"COLORED":1}}',
    'mesh/depth {"defines":{}}',
    'mesh/depth {"defines":{"CUTOUT":1,"COLORED":1}}',
  ]);
});
