import { describe, expect, test, vi } from "vitest";
import { CandleFlame, type Options } from "../../src/candle-flame.ts";
import type { CanvasTarget } from "../../src/scenes/canvas-target.ts";
import type { Scene } from "../../src/scenes/scene.ts";
import { allFeatures, FIELDS_OF_VIEW } from "../../src/settings.ts";
import { advance } from "../../src/world/advance.ts";
import { blow, moveCamera, placeCandle } from "../../src/world/commands.ts";
import { litFlames } from "../../src/world/flames.ts";
import { STILL } from "../../src/world/player/intent.ts";
import type { Wick } from "../../src/world/standing-candle.ts";
import { currentTime, fieldOfViewOf } from "../../src/world/world.ts";

const OPTIONS = {
  look: "paper",
  seed: 1,
  quality: "low",
  wind: { speed: 0, direction: 0, gustiness: 0 },
  moon: { illuminance: null, direction: null },
} as Options;

const WICKS: readonly Wick[] = [1, 2].map((x) => ({
  name: `wick.00${x}`,
  position: [0.1 * x, 0, 0],
  wickDiameter: 0.002,
}));

/** A candle that draws nothing. */
function create(
  isModelAlone: boolean,
  wicks: readonly Wick[] = [],
  look: Options["look"] = "paper",
): CandleFlame {
  const createRenderer = () => ({ resize: () => {}, setLayers: () => {} });
  const moonDirection = [0, -1, 0];
  const scene = {
    wicks,
    room: null,
    createPlume: null,
    moonDirection,
    isModelAlone,
    createRenderer,
  };
  const canvas = { ownerDocument: { defaultView: globalThis } };
  const target = { canvas, gpu: { isLost: false, longestSide: 4096 } };
  return new CandleFlame(
    target as unknown as CanvasTarget,
    scene as unknown as Scene,
    allFeatures(),
    { ...OPTIONS, look },
  );
}

test("a look, which lone candles have none of, leaves their world as it is, and is reported", () => {
  const candle = create(true);
  const { world } = candle;
  candle.onLookChanged = vi.fn();
  candle.options = { ...OPTIONS, look: "original" };
  expect(candle.world).toBe(world);
  expect(candle.onLookChanged).toHaveBeenCalledOnce();
});

test("a candle that was put down stands there again after a look that has a place of its own for it", () => {
  const candle = create(false);
  placeCandle(candle.world);
  const { position } = candle.world.candle;
  candle.onCandleMoved = vi.fn();
  for (const look of ["original", "paper"] as const) candle.options = { ...OPTIONS, look };
  expect(candle.world.candle).toMatchObject({ isHeld: false, position: [...position] });
  expect(candle.onCandleMoved).not.toHaveBeenCalled();
  candle.options = { ...OPTIONS, look: "original" };
  candle.reset();
  candle.options = OPTIONS;
  expect(candle.world.candle.isHeld, "as if new").toBe(true);
});

test("a field of view that the page has set stays through a look that has the same one", () => {
  const candle = create(false, [], "physical");
  const turn = (fieldOfView: number) => moveCamera(candle.world, [0, 1.6, 2], 0, 0, fieldOfView);
  turn(FIELDS_OF_VIEW.paper);
  candle.options = OPTIONS;
  turn(fieldOfViewOf(candle.world));
  candle.options = { ...OPTIONS, look: "physical" };
  expect(fieldOfViewOf(candle.world)).toBe(FIELDS_OF_VIEW.paper);
  turn(FIELDS_OF_VIEW.physical);
  candle.options = OPTIONS;
  expect(fieldOfViewOf(candle.world), "the look's own again").toBe(FIELDS_OF_VIEW.paper);
});

test("the moon shines from where the page wants it, and from its own place when that is taken back", () => {
  const candle = create(false);
  const moon = { illuminance: null, direction: null };
  const own = { illuminance: 0.15, direction: [0, -1, 0] };
  candle.options = { ...OPTIONS, look: "physical" };
  expect(candle.world.moon).toEqual(own);
  candle.options = { ...OPTIONS, look: "physical", moon: { ...moon, direction: [1, 0, 0] } };
  expect(candle.world.moon).toEqual({ ...own, direction: [1, 0, 0] });
  candle.options = { ...OPTIONS, look: "physical", moon };
  expect(candle.world.moon).toEqual(own);
});

test("candles that go out at once are each reported so, and what a listener does to them afterwards", () => {
  const candle = create(true, WICKS);
  candle.draw = () => {};
  const reports: string[] = [];
  candle.onFlameChanged = (index, isLit) => {
    reports.push(`${index} ${isLit ? "burns" : "is out"}`);
    if (reports.length === 1) candle.reset();
  };
  blow(candle.world, 10);
  candle.step(1);
  const out = ["0 is out", "1 is out", "2 is out"];
  expect(reports).toEqual([...out, "0 burns", "1 burns", "2 burns"]);
  expect(litFlames(candle.world)).toEqual([true, true, true]);
});

test("a candle that a listener puts down is reported once, after what had happened before", () => {
  const candle = create(false);
  placeCandle(candle.world);
  candle.setLit(false);
  const reports: string[] = [];
  candle.onFlameChanged = () => {
    reports.push("light");
    candle.options = { ...OPTIONS, look: "original" };
  };
  candle.onCandleMoved = (isHeld) => reports.push(isHeld ? "take" : "place");
  candle.reset();
  expect(reports).toEqual(["light", "take", "place"]);
});

test("of options that a listener sets while others are applied, the last ones hold", () => {
  const candle = create(true, WICKS);
  const reports: string[] = [];
  candle.onFlameChanged = (index, isLit) => {
    reports.push(`${index} ${isLit ? "burns" : "is out"}`);
    if (reports.length === 1) candle.options = { ...OPTIONS, litWicks: [0, 2] };
  };
  candle.options = { ...OPTIONS, litWicks: [1] };
  expect(litFlames(candle.world)).toEqual([true, false, true]);
  expect(reports).toEqual(["0 is out", "2 is out", "0 burns", "1 is out", "2 burns"]);
});

describe("a world that goes on from another", () => {
  const moved = (): CandleFlame => {
    const candle = create(false, WICKS, "physical");
    candle.setLit(true, 2);
    moveCamera(candle.world, [1, 1.6, 2], 0.4, -0.1, 1.2);
    placeCandle(candle.world);
    moveCamera(candle.world, [2, 1.6, 3], 0.5, -0.2);
    return candle;
  };

  test("has its time, its camera and its candles", () => {
    const { world: before } = moved();
    advance(before, STILL, 0.205);
    const candle = create(false, WICKS, "physical");
    candle.resume(before, false, true);
    const { world } = candle;
    expect(candle.currentTime).toBe(currentTime(before));
    expect(world.player).toEqual(before.player);
    expect(world.candle).toEqual(before.candle);
    expect(world.emitter).toEqual(before.emitter);
    expect(litFlames(world)).toEqual([false, false, true]);
    expect(world.fieldOfView).toBe(1.2);
  });

  test("begins at the start of another room, at the same time", () => {
    const { world: before } = moved();
    advance(before, STILL, 0.205);
    const candle = create(false, WICKS, "physical");
    const { player } = candle.world;
    candle.resume(before, false, false);
    expect(candle.currentTime).toBe(currentTime(before));
    expect(candle.world.player).toEqual(player);
    expect(candle.world.candle.isHeld).toBe(true);
    expect(litFlames(candle.world)).toEqual([false, false, false]);
    expect(candle.world.fieldOfView).toBe(1.2);
  });

  test("knows what a look that has its own place, and no other candles, had before it", () => {
    const gone = moved();
    const { position } = gone.world.candle;
    gone.options = { ...OPTIONS, look: "original" };
    const candle = create(false, WICKS, "original");
    candle.resume(gone.world, true, true);
    candle.options = { ...OPTIONS, look: "physical" };
    expect(candle.world.candle).toMatchObject({ isHeld: false, position: [...position] });
    expect(litFlames(candle.world)).toEqual([true, false, true]);
  });
});
