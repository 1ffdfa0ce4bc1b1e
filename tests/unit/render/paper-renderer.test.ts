import { expect, test } from "vitest";
import { type Material, type Model, PLAIN_MATERIAL } from "../../../src/assets/model.ts";
import type { Draw, Gpu } from "../../../src/gl/gpu.ts";
import type { FrameSettings } from "../../../src/render/frame-settings.ts";
import { PaperRenderer } from "../../../src/render/paper-renderer.ts";
import { REFINED } from "../../../src/render/refinement/refined-tier.ts";
import { allFeatures } from "../../../src/settings.ts";
import { createWorld } from "../../support/world.ts";
import { floorOf } from "../world/rooms.ts";

/** How the paper's renderer draws floors of some materials. */
function drawn(materials: readonly Partial<Material>[]): string[] {
  const draws: Draw[] = [];
  const gpu = {
    share: (_: unknown, make: () => unknown) => make(),
    program: (...[, , , options]: Parameters<Gpu["program"]>) => options?.defines,
    pass: () => ({}),
    uniformBlock: () => ({ update: () => {} }),
    vertexArray: () => ({}),
    buffer: () => ({}),
    texture: () => ({}),
    renderTarget: () => ({}),
    setColorSpace: () => {},
    clear: () => {},
    resolve: () => {},
    draw: (draw: Draw) => draws.push(draw),
  } as unknown as Gpu;
  const parts = materials.map((material) => ({
    ...floorOf(1),
    material: { ...PLAIN_MATERIAL, ...material },
  }));
  const models = { room: { parts } as unknown as Model, candle: { parts: [] } as unknown as Model };
  const renderer = new PaperRenderer(gpu, models, REFINED, "paper");
  renderer.resize(8, 8);
  const settings = { features: allFeatures(), exposure: 0 } as FrameSettings;
  renderer.render(createWorld("paper", 1), settings);
  return draws
    .filter(({ target }) => target !== "canvas")
    .map(({ cull, program }) => `${cull} ${(program as unknown as { CUTOUT: number }).CUTOUT}`);
}

test("the paper's looks draw both sides and the holes of a room's own materials", () => {
  const materials = [{}, { isDoubleSided: true }, { alphaMode: "mask" }, { alphaMode: "blend" }];
  expect(drawn(materials as Partial<Material>[])).toEqual(["back 0", "none 0", "back 1", "back 1"]);
});
