import { expect, test } from "vitest";
import type { Gpu } from "../../../src/gl/gpu.ts";
import type { Mesh } from "../../../src/render/mesh/mesh.ts";
import { MeshCasters } from "../../../src/render/shadow/shadow-casters.ts";

test("Programs of a model's casters, whole and cut out, are requested before any is drawn", () => {
  const requested: string[] = [];
  const program = (label: string, _vertex: unknown, _fragment: unknown, options = {}) =>
    requested.push(`${label} ${JSON.stringify(options)}`);
  const gpu = { program, pass() {}, renderTarget() {} } as unknown as Gpu;
  const mesh = (isCutOut: boolean) =>
    ({ isCutOut, uniforms: { uSurface: [0, 0, 0, isCutOut ? 0.5 : 0] } }) as unknown as Mesh;
  const meshes = [mesh(false), mesh(true)];
  new MeshCasters(gpu, meshes);
  expect(requested).toEqual([
    'shadow/shadow {"defines":{}}',
    'shadow/shadow {"defines":{"CUTOUT":1}}',
  ]);
});
