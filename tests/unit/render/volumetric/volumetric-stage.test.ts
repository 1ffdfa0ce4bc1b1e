import { expect, test } from "vitest";
import type { Gpu } from "../../../../src/gl/gpu.ts";
import type { FrameInput } from "../../../../src/render/frame-input.ts";
import type { Captures } from "../../../../src/render/gi/light-captures.ts";
import type { Mesh } from "../../../../src/render/mesh/mesh.ts";
import type { FrameBlocks } from "../../../../src/render/opaque/opaque-stage.ts";
import { REFINED } from "../../../../src/render/refinement/refined-tier.ts";
import { VolumetricStage } from "../../../../src/render/volumetric/volumetric-stage.ts";
import type { CompositedFrame } from "../../../../src/render/volumetric/volumetric-target.ts";
import { finish } from "../../../../src/world/steps.ts";
import { createWorld } from "../../../support/world.ts";

/** Indices of a wick's cluster. */
const CLUSTER = 30;

test("an ember is drawn with its own wick: with no other candle's, be they one mesh or many", () => {
  const places = [0, 1, 2, 3];
  const draws: string[] = [];
  const gpu = {
    program: (label: string) => label,
    uniformBlock: () => ({}),
    texture: () => ({}),
    buffer: () => ({}),
    vertexArray: () => ({}),
    draw: ({ program, vertexArray, first }: Record<string, unknown>) => {
      if (program === "volumetric/ember") draws.push(`${vertexArray} ${first}`);
    },
  } as unknown as Gpu;
  const meshOf = (name: string, xs: readonly number[]) => {
    const clusters = xs.map((x, i) => ({
      min: [x - 0.001, 1, -0.001],
      max: [x + 0.001, 1.012, 0.001],
      first: i * CLUSTER,
      count: CLUSTER,
    }));
    return { isWick: true, vertexArray: name, clusters } as unknown as Mesh;
  };
  const world = createWorld("physical", 1, {
    wicks: places.map((x) => ({ name: `wick.${x}`, position: [x, 1, 0], wickDiameter: 0.002 })),
    areLit: places.map(() => true),
  });
  const frame = {
    world,
    settings: { features: { candle: false, volume: false }, inspect: "picture" },
  } as unknown as FrameInput;
  const embersOf = (room: readonly Mesh[]) => {
    const blocks = {} as FrameBlocks;
    const stage = new VolumetricStage(gpu, [], room, blocks, "RGBA16F", REFINED.physical);
    draws.length = 0;
    finish(stage.render(frame, {} as CompositedFrame, {} as Captures));
    return [...draws];
  };
  expect(embersOf(places.map((x) => meshOf(`mesh.${x}`, [x])))).toEqual([
    "mesh.0 0",
    "mesh.1 0",
    "mesh.2 0",
    "mesh.3 0",
  ]);
  const ends = places.map((i) => `all ${i * CLUSTER}`);
  expect(embersOf([meshOf("all", places)])).toEqual(ends);
});
