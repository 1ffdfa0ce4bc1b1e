import { expect, test } from "vitest";
import { fetchKeyNames, nameKeys } from "../../src/key-names.ts";

const AZERTY = new Map([
  ["KeyW", "z"],
  ["KeyA", "q"],
  ["KeyE", "e"],
]);

async function named(navigator: Parameters<typeof fetchKeyNames>[0]): Promise<(string | null)[]> {
  const caps = ["W", "A", "E", "Esc"].map((textContent) => ({ textContent }));
  await nameKeys(caps, fetchKeyNames(navigator));
  return caps.map(({ textContent }) => textContent);
}

test("keys are named as on the visitor's keyboard, where the browser knows it", async () => {
  const keyboard = { getLayoutMap: () => Promise.resolve(AZERTY) };
  expect(await named({ keyboard })).toEqual(["Z", "Q", "E", "Esc"]);
});

test("else they keep the page's names", async () => {
  const keyboard = { getLayoutMap: () => Promise.reject(new Error("not allowed")) };
  for (const navigator of [{}, { keyboard: {} }, { keyboard }]) {
    expect(await named(navigator)).toEqual(["W", "A", "E", "Esc"]);
  }
});
