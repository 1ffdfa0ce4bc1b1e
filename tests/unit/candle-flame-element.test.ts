import { describe, expect, test, vi } from "vitest";
import { SETTINGS } from "../../src/settings.ts";

describe("on a server, where there is no page", () => {
  test("the test runs without a DOM", () => {
    for (const name of ["HTMLElement", "document", "window", "customElements"]) {
      expect(globalThis).not.toHaveProperty(name);
    }
  });

  test("the element's module loads, and says which attributes it observes", async () => {
    const { CandleFlameElement } = await import("../../src/candle-flame-element.ts");
    expect(CandleFlameElement.observedAttributes.toSorted()).toEqual(
      Object.keys(SETTINGS).toSorted(),
    );
  });

  test("importing its definition defines nothing, and does not throw", async () => {
    await expect(import("../../src/define.ts")).resolves.toBeDefined();
    expect(globalThis).not.toHaveProperty("customElements");
  });
});

test.each([
  ["jsdom", ["attachInternals"], []],
  ["happy-dom", [], []],
  ["browsers", ["attachInternals", "part"], ["candle-flame"]],
])("in the DOM of %s what is there decides whether the tag is defined", async (_, names, tags) => {
  const defined: string[] = [];
  const define = (name: string) => defined.push(name);
  vi.resetModules();
  vi.stubGlobal("customElements", { get: () => undefined, define });
  const HTMLElement = class {};
  for (const name of names) Object.assign(HTMLElement.prototype, { [name]: {} });
  vi.stubGlobal("HTMLElement", HTMLElement);
  await import("../../src/define.ts");
  vi.unstubAllGlobals();
  expect(defined).toEqual(tags);
});
