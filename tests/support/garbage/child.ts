import { advance } from "../../../src/world/advance.ts";
import { createPlume } from "../../../src/world/air/plume.ts";
import type { WorldOptions } from "../../../src/world/create-world.ts";
import { type Intent, STILL } from "../../../src/world/player/intent.ts";
import { CollisionMesh } from "../../../src/world/room/collision-mesh.ts";
import { createRoom } from "../../../src/world/room/room.ts";
import type { World } from "../../../src/world/world.ts";
import { FURNISHED } from "../../unit/world/rooms.ts";
import { createWorld } from "../world.ts";

/** Frames of 1/60 s: until all is compiled, and in each of the stretches that are measured. */
const WARM_UP = Number(process.argv[2]);
const STRETCH = 60;
const STRETCHES = 5;
const TICKS_PER_FRAME = 2;

const GUSTS: WorldOptions = { wind: { speed: 0.3, direction: 0, gustiness: 1 } };

interface Case {
  readonly birth: WorldOptions;
  readonly intent: Intent;
  /** What is done before a frame. */
  readonly deed: (world: World, frame: number) => void;
}

/** Puts the candle out, and lights it again before its smoke is gone. */
function smoke({ flame }: World, frame: number): void {
  if (frame % 240 === 0) flame.extinguish();
  if (frame % 240 === 180) flame.light();
}

const CASES: Readonly<Record<string, Case>> = {
  gusts: { birth: GUSTS, intent: STILL, deed: () => {} },
  walking: {
    birth: { ...GUSTS, room: createRoom(new CollisionMesh(FURNISHED.parts), null) },
    intent: { ...STILL, forward: 1, turn: 0.3 },
    deed: () => {},
  },
  smoke: { birth: GUSTS, intent: STILL, deed: smoke },
  still: { birth: {}, intent: STILL, deed: () => {} },
};

/** Bytes that each tick leaves to the collector: of several stretches the least, as compilers leave some too. */
function garbageOf({ birth, intent, deed }: Case): number {
  const world = createWorld("physical", 1, { ...birth, createPlume });
  let frame = 0;
  const go = (frames: number): void => {
    for (const end = frame + frames; frame < end; frame++) {
      deed(world, frame);
      advance(world, intent, 1 / 60);
    }
  };
  go(WARM_UP);
  let least = Number.POSITIVE_INFINITY;
  for (let i = 0; i < STRETCHES; i++) {
    const before = process.memoryUsage().heapUsed;
    go(STRETCH);
    const garbage = process.memoryUsage().heapUsed - before;
    // A collection in between would show as a gain; there is none, since the nursery is large.
    if (garbage >= 0) least = Math.min(least, garbage / (STRETCH * TICKS_PER_FRAME));
  }
  return least;
}

const asked = Object.entries(CASES).filter(([name]) => process.argv.includes(name, 3));
const garbage = asked.map(([name, each]) => [name, Math.round(garbageOf(each))]);
console.log(JSON.stringify(Object.fromEntries(garbage)));
