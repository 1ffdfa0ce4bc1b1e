import { afterAll, beforeAll, expect, test, vi } from "vitest";
import type { CandleFlameElement } from "../../../src/candle-flame-element.ts";
import { followDrawnLook } from "../../../src/page/drawn-look.ts";
import { climb, RUNGS } from "../../../src/page/lab/ladder.ts";
import { allFeatures } from "../../../src/settings.ts";

/** As much of the element as is measured: its room comes when it is told to. */
class Room extends EventTarget {
  readonly features = allFeatures();
  paused = false;
  /** Looks that were on show while frames were drawn. */
  readonly drawn = new Set<string>();
  #look = "physical";
  #shown = "physical";

  get look(): string {
    return this.#look;
  }
  set look(look: string) {
    if ((look === "physical") === (this.#look === "physical")) this.#shown = look;
    this.#look = look;
  }
  arrive(): void {
    this.#shown = this.#look;
    this.dispatchEvent(new Event("load"));
  }
  getAttribute(): string {
    return this.#look;
  }
  setAttribute(_: string, look: string): void {
    this.look = look;
  }
  pause(): void {
    this.paused = true;
  }
  step(): void {
    this.drawn.add(this.#shown);
  }
  readRadiance(): void {}
}

/** Gives the medians of each rung. */
async function begin(room: Room, signal = new AbortController().signal) {
  let last: readonly number[] = [];
  await climb(room as unknown as CandleFlameElement, 1, signal, (_, medians) => {
    last = medians;
  });
  return last;
}

/** A document whose GPU has some extensions. */
const documentWith = (...names: readonly string[]) => {
  const getExtension = (name: string) => (names.includes(name) ? {} : null);
  return { createElement: () => ({ getContext: () => ({ getExtension }) }) };
};

beforeAll(() => {
  vi.stubGlobal("requestAnimationFrame", (run: () => void) => setTimeout(run));
  vi.stubGlobal("document", documentWith("EXT_color_buffer_half_float"));
});
afterAll(() => void vi.unstubAllGlobals());

test("from another look, nothing is measured before the paper's room is there", async () => {
  const room = new Room();
  const climbing = begin(room);
  await new Promise((resolve) => setTimeout(resolve, 20));
  expect(room.drawn).toEqual(new Set());
  room.arrive();
  expect(await climbing).toHaveLength(RUNGS.length);
  expect(room.drawn).toEqual(new Set(["paper"]));
  expect([room.look, room.paused]).toEqual(["physical", false]);
});

test("the look on show counts while another is loading", async () => {
  const room = new Room();
  followDrawnLook(room as unknown as CandleFlameElement);
  room.arrive();
  room.look = "paper";
  const climbing = begin(room);
  await new Promise((resolve) => setTimeout(resolve, 20));
  expect(room.drawn).toEqual(new Set());
  room.arrive();
  await climbing;
  expect(room.drawn).toEqual(new Set(["paper"]));
  room.look = "physical"; // dropped by the climb, without an event
  expect(await begin(room)).toHaveLength(RUNGS.length);
});

test("a climb that is stopped while the paper's room loads restores the look", async () => {
  const room = new Room();
  const stop = new AbortController();
  const climbing = begin(room, stop.signal);
  stop.abort(new Error("enough"));
  await expect(climbing).rejects.toThrow("enough");
  expect([room.look, room.paused, room.drawn.size]).toEqual(["physical", false, 0]);
});

test("a room that fails to load rejects with the reason", async () => {
  const room = new Room();
  const climbing = begin(room);
  room.dispatchEvent(Object.assign(new Event("error"), { detail: { message: "no room." } }));
  await expect(climbing).rejects.toThrow("no room.");
  expect(room.look).toBe("physical");
});

test("where targets hold no floats, the paper's room is there already", async () => {
  vi.resetModules();
  vi.stubGlobal("document", documentWith());
  const { climb } = await import("../../../src/page/lab/ladder.ts");
  const room = new Room() as unknown as CandleFlameElement;
  const { signal } = new AbortController();
  expect(await climb(room, 1, signal, () => {})).toBeGreaterThan(0);
});
