import { expect, test, vi } from "vitest";
import type { CandleFlame } from "../../../src/candle-flame.ts";
import { CandleReporter } from "../../../src/element/candle-reporter.ts";
import type { CustomStates } from "../../../src/element/custom-states.ts";
import type { Overlay } from "../../../src/element/overlay.ts";
import type { ReflectedAttributes } from "../../../src/element/reflected-attributes.ts";
import { describeControls } from "../../../src/input/describe-controls.ts";

const VISITED = { input: { describe: describeControls } } as CandleFlame;

test("entering a lone candle is told as such: the controls are fewer", () => {
  const states = { toggle() {}, has: (name: string) => name !== "walking" };
  const hint = { tellControls: vi.fn() };
  const reporter = new CandleReporter(
    new EventTarget() as ReflectedAttributes,
    states as unknown as CustomStates,
    { hint } as unknown as Overlay,
  );
  reporter.entered(VISITED, true, "keyboard");
  const controls = expect.stringMatching(/^\[E\] .*\[B\] blows/) as string;
  expect(hint.tellControls.mock.calls).toEqual([["keyboard", controls]]);
});

test("a device that proves to be another has its controls told, and nobody enters again", async () => {
  const element = new EventTarget() as ReflectedAttributes;
  const has = new Set(["playing"]);
  const states = {
    toggle: (name: string, isOn: boolean) => (isOn ? has.add(name) : has.delete(name)),
    has: (name: string) => has.has(name),
  };
  const hint = { tellControls: vi.fn() };
  const reporter = new CandleReporter(
    element,
    states as unknown as CustomStates,
    { hint } as unknown as Overlay,
  );
  const events: string[] = [];
  element.addEventListener("enter", () => events.push("enter"));
  reporter.entered(VISITED, true, "mouse");
  reporter.entered(VISITED, true, "drag");
  await Promise.resolve();
  expect(hint.tellControls.mock.calls.map(([device]) => device)).toEqual(["mouse", "drag"]);
  expect(events).toEqual(["enter"]);
});

/** A candle with nothing but its carried flame, which is out by now. */
function createCandle(): CandleFlame {
  const world = { player: { position: [0, 0, 0] }, fieldOfView: 1, flame: { isLit: false } };
  return { world, view: {}, candleNames: ["wick", "wick.001"] } as unknown as CandleFlame;
}

test("a flame's event names what it did then, and is sent when another candle is shown already", () => {
  const element = new EventTarget() as ReflectedAttributes;
  const states = { toggle: vi.fn(), has: () => false, clear() {} };
  const hint = { tellFlame: vi.fn() };
  const reporter = new CandleReporter(
    element,
    states as unknown as CustomStates,
    { hint } as unknown as Overlay,
  );
  const events: string[] = [];
  for (const type of ["light", "extinguish"] as const) {
    element.addEventListener(type, ({ detail }) => events.push(`${type} ${detail.name}`));
  }
  const candle = createCandle();
  reporter.watch(candle);
  candle.onFlameChanged(1, true);
  expect(hint.tellFlame).toHaveBeenLastCalledWith(false, false, "Candle 2 burns.");
  reporter.stop();
  candle.onFlameChanged(0, false);
  expect(events).toEqual(["light wick.001", "extinguish wick"]);
  expect(hint.tellFlame).toHaveBeenCalledOnce();
  expect(states.toggle).toHaveBeenCalledOnce();
});

test("who enters while time stands is shown the controls once it passes", () => {
  const states = { toggle() {}, has: (name: string) => name === "walking" };
  const hint = { tellControls: vi.fn(), tellFlame: vi.fn() };
  const reporter = new CandleReporter(
    new EventTarget() as ReflectedAttributes,
    states as unknown as CustomStates,
    { hint } as unknown as Overlay,
  );
  const candle = Object.assign(createCandle(), VISITED);
  reporter.watch(candle);
  reporter.entered(candle, true, "keyboard");
  reporter.flame(candle);
  expect(hint.tellControls).not.toHaveBeenCalled();
  expect(hint.tellFlame).toHaveBeenLastCalledWith(false, false, null);
  reporter.frame(candle);
  reporter.frame(candle);
  reporter.flame(candle);
  const controls = expect.stringContaining("walk") as string;
  expect(hint.tellControls.mock.calls).toEqual([["keyboard", controls]]);
  expect(hint.tellFlame).toHaveBeenLastCalledWith(false, true, null);
});

test("entering and leaving are reported in their order, once what they interrupt is done", async () => {
  const element = new EventTarget() as ReflectedAttributes;
  const states = { toggle() {}, has: () => false } as unknown as CustomStates;
  const hint = { tellControls() {}, tellFlame() {} };
  const reporter = new CandleReporter(element, states, { hint } as unknown as Overlay);
  const candle = { world: { flame: { isLit: true } } } as CandleFlame;
  const events: string[] = [];
  for (const type of ["enter", "leave"]) {
    element.addEventListener(type as "enter", () => events.push(type));
  }
  reporter.entered(candle, true, "mouse");
  reporter.entered(candle, false, "mouse");
  expect(events).toEqual([]);
  await Promise.resolve();
  expect(events).toEqual(["enter", "leave"]);
});
