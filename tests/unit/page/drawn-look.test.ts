import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { CandleFlameElement, Look } from "../../../src/candle-flame-element.ts";

/** As much of the element as has a look. */
class Room extends EventTarget {
  look: Look = "physical";
}

/** A document whose GPU has some extensions. */
const documentWith = (...names: readonly string[]) => {
  const getExtension = (name: string) => (names.includes(name) ? {} : null);
  return { createElement: () => ({ getContext: () => ({ getExtension }) }) };
};

/** The module keeps what it finds. */
async function roomIn(document: object) {
  vi.stubGlobal("document", document);
  const { drawnLook, expectedLook, followDrawnLook } = await import(
    "../../../src/page/drawn-look.ts"
  );
  const room = new Room() as unknown as CandleFlameElement;
  followDrawnLook(room);
  return { room, looks: () => [drawnLook(room), expectedLook(room)] };
}

beforeEach(() => void vi.resetModules());
afterEach(() => void vi.unstubAllGlobals());

test("the look on show counts while another is loading", async () => {
  const { room, looks } = await roomIn(documentWith("EXT_color_buffer_half_float"));
  expect(looks()).toEqual(["physical", "physical"]);
  room.dispatchEvent(new Event("load"));
  room.look = "paper";
  expect(looks()).toEqual(["physical", "paper"]);
  room.dispatchEvent(new Event("load"));
  expect(looks()).toEqual(["paper", "paper"]);
});

test("where targets hold no floats, the paper's look is drawn for the physical one", async () => {
  const { room, looks } = await roomIn(documentWith());
  expect(looks()).toEqual(["paper", "paper"]);
  room.look = "original";
  expect(looks()).toEqual(["original", "original"]);
});
