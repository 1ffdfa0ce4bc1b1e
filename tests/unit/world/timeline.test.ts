import { describe, expect, test } from "vitest";
import { GROUPS } from "../../../src/world/particles/particle-layer.ts";
import { HISTORY, TICK, Timeline } from "../../../src/world/timeline.ts";

/** A timeline whose tick `t` holds numbers made of `t`. */
function recorded(from: number, to: number): Timeline {
  const timeline = new Timeline(from);
  for (let tick = from; tick < to; tick++) {
    timeline.record([tick, tick + 0.25, tick + 0.5], [-tick, 1 - tick, 2 - tick], tick & 3);
  }
  return timeline;
}

describe("the timeline", () => {
  test("ticks 120 times a second", () => {
    expect(TICK).toBe(1 / 120);
  });

  test.each([
    ["after time 0", 1000],
    ["while it warms the flame up, before time 0", -40],
    ["across time 0", 100],
    ["after a year", 365 * 86400 * 120],
  ])("remembers each of the last ticks: %s", (_, end) => {
    const timeline = recorded(end - 300, end);
    expect(timeline.tick).toBe(end);
    for (let tick = end - HISTORY; tick < end; tick++) {
      expect([0, 1, 2].map((axis) => timeline.way(tick, axis))).toEqual(
        [tick, tick + 0.25, tick + 0.5].map(Math.fround),
      );
      expect([0, 1, 2].map((axis) => timeline.wind(tick, axis))).toEqual(
        [-tick, 1 - tick, 2 - tick].map(Math.fround),
      );
      expect(timeline.groups(tick)).toBe(tick & 3);
    }
  });

  test("forgets the tick before those", () => {
    const timeline = recorded(0, HISTORY + 1);
    expect(timeline.way(0, 0)).toBe(HISTORY);
  });

  test("knows no births before it began", () => {
    const timeline = new Timeline(0);
    for (let tick = -HISTORY; tick < 0; tick++) expect(timeline.groups(tick)).toBe(0);
  });

  test("never bears more groups than there are", () => {
    const timeline = new Timeline(0);
    timeline.record([0, 0, 0], [0, 0, 0], 1000);
    expect(timeline.groups(0)).toBe(GROUPS);
  });
});
