import { describe, expect, test } from "vitest";
import { advance } from "../../../../src/world/advance.ts";
import { moveCamera, placeCandle } from "../../../../src/world/commands.ts";
import type { Vec3 } from "../../../../src/world/geometry.ts";
import {
  DARKEST,
  EXPOSURE_LAW,
  ExposureAdaptation,
  exposureOf,
} from "../../../../src/world/player/exposure-adaptation.ts";
import { STILL } from "../../../../src/world/player/intent.ts";
import { CollisionMesh } from "../../../../src/world/room/collision-mesh.ts";
import { createRoom } from "../../../../src/world/room/room.ts";
import type { World } from "../../../../src/world/world.ts";
import { createWorld } from "../../../support/world.ts";
import { insideOf, table } from "../rooms.ts";

const PARTS = [insideOf([-2, 0, -2], [2, 2.4, 2]), ...table(0, -0.6)];
const SOLID = new CollisionMesh(PARTS);
const IN_THE_HAND: Vec3 = [0.3, 1.45, 0.9];
const BY_THE_WALL: Vec3 = [0, 1.3, -1.7];

/** As much of a world as the eye adapts to. */
function sight(emitter: Vec3, glow = 1, fieldOfView = 0.98, moonlight = 0): World {
  const player = { position: [0, 1.6, 1.5], yaw: 0, pitch: -0.1 };
  const moon = moonlight > 0 ? { illuminance: moonlight } : null;
  return { player, fieldOfView, emitter, flame: { glow }, standing: [], moon } as unknown as World;
}

/** Seconds until the eye has made nine tenths of the way to what it sees now; and whether it ever turned back. */
function timing(adaptation: ExposureAdaptation, seen: World): { time: number; isSteady: boolean } {
  adaptation.notice(seen);
  const first = Math.abs(adaptation.lag);
  let isSteady = true;
  let time = 0;
  for (let before = first; before > 0.1 * first && time < 10; time += 1 / 60) {
    adaptation.advance(seen, 1 / 60);
    isSteady &&= Math.abs(adaptation.lag) < before;
    before = Math.abs(adaptation.lag);
  }
  return { time, isSteady };
}

const lagOf = ({ adaptation }: World) => adaptation?.lag ?? Number.NaN;

test("a wider view is another view", () => {
  const adaptation = new ExposureAdaptation(SOLID);
  adaptation.settle(sight(BY_THE_WALL));
  const { exposure } = adaptation;
  adaptation.settle(sight(BY_THE_WALL, 1, 2));
  expect(Math.abs(adaptation.exposure - exposure)).toBeGreaterThan(0.1);
});

test("beside another candle one that is lit or put out moves no exposure at once", () => {
  const world = createWorld("physical", 1, {
    room: createRoom(SOLID, null),
    wicks: [{ name: "wick", position: [0.4, 1.2, -1.5], wickDiameter: 0.002 }],
    areLit: [true],
    isLit: false,
  });
  const steps = (seconds: number) => {
    let most = 0;
    for (let tick = 0; tick < seconds * 120; tick++) {
      const before = lagOf(world);
      advance(world, STILL, 1 / 120);
      most = Math.max(most, Math.abs(lagOf(world) - before));
    }
    return most;
  };
  steps(2);
  world.flame.light();
  expect(steps(1)).toBeLessThan(0.1);
  world.flame.extinguish();
  // Its own light fades within a few ticks.
  expect(steps(1)).toBeLessThan(0.25);
});

describe("the exposure that a picture asks for", () => {
  test("never rises with its brightness, and falls by less than that rises", () => {
    const stops = Array.from({ length: 200 }, (_, i) => exposureOf(Math.log2(DARKEST) + i * 0.1));
    for (let i = 1; i < stops.length; i++) {
      const step = (stops[i - 1] ?? 0) - (stops[i] ?? 0);
      expect(step).toBeGreaterThanOrEqual(0);
      expect(step).toBeLessThan(0.1);
    }
  });

  test("is no more for a dark corner than for one twice as bright", () => {
    expect(exposureOf(Math.log2(0.004))).toBe(EXPOSURE_LAW.most);
    expect(exposureOf(Math.log2(0.002))).toBe(EXPOSURE_LAW.most);
    expect(exposureOf(Math.log2(0.02))).toBeLessThan(EXPOSURE_LAW.most);
  });
});

describe("an eye", () => {
  test("takes two to four seconds to close and to open, and does not swing", () => {
    const adaptation = new ExposureAdaptation(SOLID);
    adaptation.settle(sight(IN_THE_HAND));
    expect(adaptation.lag).toBe(0);
    for (const [flame, sign] of [
      [BY_THE_WALL, 1],
      [IN_THE_HAND, -1],
    ] as const) {
      adaptation.notice(sight(flame));
      expect(adaptation.lag * sign).toBeGreaterThan(0.3);
      const { time, isSteady } = timing(adaptation, sight(flame));
      expect(time).toBeGreaterThan(2);
      expect(time).toBeLessThan(4);
      expect(isSteady).toBe(true);
      for (let i = 0; i < 60; i++) adaptation.advance(sight(flame), 0.2);
    }
  });

  test("ends at the same exposure from brightness and from darkness", () => {
    const ends = [4, 0].map((glow) => {
      const adaptation = new ExposureAdaptation(SOLID);
      adaptation.settle(sight(IN_THE_HAND, glow));
      for (let i = 0; i < 600; i++) adaptation.advance(sight(IN_THE_HAND), 1 / 60);
      expect(Math.abs(adaptation.lag)).toBeLessThan(0.01);
      return adaptation.exposure;
    });
    expect(ends[0]).toBeCloseTo(ends[1] ?? 0, 2);
    expect(ends[0]).toBeLessThan(EXPOSURE_LAW.most);
  });

  test("follows a flickering flame by a fraction, and never by flashes", () => {
    const adaptation = new ExposureAdaptation(SOLID);
    adaptation.settle(sight(IN_THE_HAND));
    const exposures = Array.from({ length: 240 }, (_, i) => {
      // Between half a candela and two, ten times a second: worse than any flame of ours.
      adaptation.advance(sight(IN_THE_HAND, 2 ** Math.sin((i / 60) * 2 * Math.PI * 10)), 1 / 60);
      return adaptation.exposure;
    });
    const late = exposures.slice(120);
    expect(Math.max(...late) - Math.min(...late)).toBeLessThan(0.1);
  });

  test("is as far behind at 30, 60 and 144 Hz and after one long frame, and not at all after a cut", () => {
    const room = createRoom(SOLID, { position: [0, 0, 0.6], yaw: 0 });
    const lags = [30, 60, 144, 2].map((rate) => {
      const world = createWorld("physical", 1, { room });
      expect(world.adaptation?.lag).toBe(0);
      moveCamera(world, [0, 1.6, 0.4], 0, -0.8);
      expect(world.adaptation?.lag).toBe(0);
      expect(placeCandle(world)).toBe(true);
      for (let i = 0; i < rate / 2; i++) advance(world, STILL, 1 / rate);
      const { player } = world;
      const lag = lagOf(world);
      expect(Math.abs(lag)).toBeGreaterThan(0.01);
      moveCamera(world, [...player.position], player.yaw, player.pitch);
      expect(world.adaptation?.lag, "the camera stayed where it was").toBe(lag);
      moveCamera(world, [...player.position], player.yaw + 0.1, player.pitch);
      expect(world.adaptation?.lag).toBe(0);
      return lag;
    });
    expect(new Set(lags).size).toBe(1);
  });
});

test("in moonlight alone the eye adapts to the dark in twenty seconds, and loses that to a flame in two", () => {
  const [out, lit] = [0, 1].map((glow) => sight(IN_THE_HAND, glow, 0.98, 0.15)) as [World, World];
  const adaptation = new ExposureAdaptation(SOLID);
  adaptation.settle(sight(IN_THE_HAND));
  for (let i = 0; i < 600; i++) adaptation.advance(out, 1 / 60);
  expect(adaptation.darkness).toBeCloseTo(0.5, 6);
  const { exposure } = adaptation;
  for (let i = 0; i < 660; i++) adaptation.advance(out, 1 / 60);
  expect(adaptation.darkness).toBe(1);
  expect(adaptation.exposure).toBeGreaterThan(exposure + 1);
  for (let i = 0; i < 120; i++) adaptation.advance(lit, 1 / 60);
  expect(adaptation.darkness).toBeLessThan(0.12);
  adaptation.adaptFully(out);
  expect(adaptation.darkness).toBe(1);
});

test("where no moon shines, an unlit room stays as black as at first", () => {
  const adaptation = new ExposureAdaptation(SOLID);
  for (let i = 0; i < 60; i++) adaptation.advance(sight(IN_THE_HAND, 0), 1);
  adaptation.adaptFully(sight(IN_THE_HAND, 0));
  expect(adaptation.darkness).toBe(0);
});
