import { type HeapProfiler, Session } from "node:inspector";
import { expect, test } from "playwright/test";
import { STILL } from "../../src/world/intent.ts";
import { advance, blow, createWorld, type World } from "../../src/world/world.ts";

/** Most that a frame's world may take of one core, in milliseconds. */
const MOST = 2;
const FRAMES = 600;
/** Most that a tick may leave to the collector, bytes: numbers that calls which are not inlined box. */
const LITTER = 1000;

const CASES: readonly { readonly name: string; readonly prepare: (world: World) => void }[] = [
  { name: "a candle in gusts", prepare: () => {} },
  { name: "smoke of one blown out", prepare: (world) => blow(world, 1) },
];

test("the world takes a small part of a frame of 1/60 s", () => {
  for (const { name, prepare } of CASES) {
    const world = createWorld("physical", 1, {
      wind: { speed: 0.3, direction: 0, gustiness: 1 },
    });
    prepare(world);
    advance(world, STILL, 1);
    const times = Array.from({ length: FRAMES }, () => {
      const begin = performance.now();
      advance(world, STILL, 1 / 60);
      return performance.now() - begin;
    }).sort((a, b) => a - b);
    // Others' work on the machine only ever adds to it: the quickest is what it costs.
    const cost = times[0] ?? 0;
    const median = times[FRAMES / 2] ?? 0;
    console.log(`${name}: ${cost.toFixed(2)} ms a frame, median ${median.toFixed(2)} ms`);
    expect(cost, name).toBeLessThan(MOST);
  }
});

/** What a profile's functions have allocated, bytes. */
function allocated({ selfSize, children }: HeapProfiler.SamplingHeapProfileNode): number {
  return children.reduce((sum, child) => sum + allocated(child), selfSize);
}

test("the world leaves next to nothing to the collector", () => {
  const session = new Session();
  session.connect();
  for (const { name, prepare } of CASES) {
    const world = createWorld("physical", 1, {
      wind: { speed: 0.3, direction: 0, gustiness: 1 },
    });
    prepare(world);
    // Until all is compiled.
    for (let frame = 0; frame < FRAMES; frame++) advance(world, STILL, 1 / 60);
    prepare(world);
    session.post("HeapProfiler.startSampling", {
      samplingInterval: 1024,
      includeObjectsCollectedByMajorGC: true,
      includeObjectsCollectedByMinorGC: true,
    });
    for (let frame = 0; frame < FRAMES; frame++) advance(world, STILL, 1 / 60);
    let litter = Number.NaN;
    session.post("HeapProfiler.stopSampling", (_error, { profile }) => {
      litter = allocated(profile.head) / (2 * FRAMES);
    });
    console.log(`${name}: ${litter.toFixed(0)} bytes a tick`);
    expect(litter, name).toBeLessThan(LITTER);
  }
  session.disconnect();
});
