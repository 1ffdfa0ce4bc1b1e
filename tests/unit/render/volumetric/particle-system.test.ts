import { expect, test } from "vitest";
import type { Gpu } from "../../../../src/gl/gpu.ts";
import { ParticleSystem } from "../../../../src/render/volumetric/particle-system.ts";
import { PHYSICAL_LAYERS } from "../../../../src/world/particles/particle-layer.ts";
import { Timeline } from "../../../../src/world/timeline.ts";

test("particles that lived when drawing stopped are aged, and do not come back with the next ones", () => {
  const object = () => ({ dispose() {}, update() {}, read() {} });
  const counts: number[] = [];
  const gpu = {
    buffer: object,
    vertexArray: object,
    uniformBlock: object,
    program: object,
    draw: ({ count }: { count: number }) => counts.push(count),
  };
  const sparks = PHYSICAL_LAYERS.find(({ name }) => name === "spark");
  if (!sparks) throw new Error("The physical look has sparks.");
  const system = new ParticleSystem(gpu as unknown as Gpu, sparks, 1);
  const timeline = new Timeline(0);
  const record = (ticks: number, isSparking: boolean) => {
    for (let tick = 0; tick < ticks; tick++) timeline.record([0, 0, 0], [0, 0, 0], 4, isSparking);
  };
  record(4, true);
  system.follow(timeline);
  record(600, false);
  counts.length = 0;
  system.follow(timeline);
  expect(counts.length).toBeGreaterThan(0);
  expect(Math.min(...counts), "points of a pass").toBe(sparks.capacity);
});
