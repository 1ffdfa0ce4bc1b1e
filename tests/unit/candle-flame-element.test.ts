import { describe, expect, test } from "vitest";
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
