import { mat4 } from "gl-matrix";
import { expect, test } from "vitest";
import type { Gpu, Program, Texture } from "../../../src/gl/gpu.ts";
import type { CachedLight } from "../../../src/render/cached-light.ts";
import type { FrameInput } from "../../../src/render/frame-input.ts";
import type { GBuffer } from "../../../src/render/gbuffer/gbuffer.ts";
import { CachedLighting } from "../../../src/render/opaque/cached-lighting.ts";
import type { FrameBlocks } from "../../../src/render/opaque/opaque-stage.ts";
import { REFINED } from "../../../src/render/refinement/refined-tier.ts";
import { finish } from "../../../src/world/steps.ts";
import { createWorld } from "../../support/world.ts";

test("the lighting of a candle that is out is freed, and all of it on request", () => {
  const alive = new Set<string>();
  const gpu = {
    renderTarget({ label }: { label: string }) {
      alive.add(label);
      return { color: {}, dispose: () => alive.delete(label) };
    },
    pass: () => null,
    draw: () => {},
  } as unknown as Gpu;
  const blocks = { Frame: {}, Light: { update: () => {} } } as unknown as FrameBlocks;
  const { shadow } = REFINED.physical;
  const lighting = new CachedLighting(gpu, shadow, "RGBA16F", blocks, {} as Program);
  const frame = {
    world: createWorld("physical", 1),
    settings: { features: {} },
    clipFromWorld: mat4.create(),
  } as unknown as FrameInput;
  const texture = { width: 8, height: 8 } as Texture;
  const light = (name: string) =>
    ({
      kind: "candle",
      name,
      key: name,
      intensity: [1, 1, 1],
      irradiance: {},
    }) as unknown as CachedLight;
  const render = (...names: string[]) => {
    finish(lighting.render(frame, {} as GBuffer, texture, names.map(light)));
    return [...alive].filter((label) => !/sum/.test(label));
  };
  expect(render("a", "b")).toEqual(["lighting/a", "lighting/b"]);
  expect(render("b", "c")).toEqual(["lighting/b", "lighting/c"]);
  lighting.release();
  expect([...alive]).toEqual([]);
});
