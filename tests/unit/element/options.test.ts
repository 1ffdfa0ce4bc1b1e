import { expect, test } from "vitest";
import { assetRootOf, optionsOf } from "../../../src/element/options.ts";
import type { ReflectedAttributes } from "../../../src/element/reflected-attributes.ts";

/** Options of an element that has these attributes. */
function optionsWith(attributes: Readonly<Record<string, string>>, properties: object = {}) {
  const defaults = { motion: "full", wick: 2, litWicks: "", moonDirection: "", gustiness: 0 };
  const getAttribute = (name: string) => attributes[name] ?? null;
  const element = { ...defaults, getAttribute, ...properties };
  return optionsOf(element as unknown as ReflectedAttributes, "physical");
}

test("for visitors who want less motion the wind blows without gusts", () => {
  const gustinessOf = (motion: "reduced" | "full") =>
    optionsWith({}, { motion, gustiness: 0.5 }).wind.gustiness;
  expect(gustinessOf("full")).toBe(0.5);
  expect(gustinessOf("reduced")).toBe(0);
});

test("a visitor is asked for less motion in the window that shows the element", () => {
  const stillIn = (matches: boolean) => {
    const ownerDocument = { defaultView: { matchMedia: () => ({ matches }) } };
    return optionsWith({}, { motion: "auto", ownerDocument }).isStill;
  };
  expect([stillIn(true), stillIn(false)]).toEqual([true, false]);
});

test("a wick that is no number is the model's own", () => {
  expect(optionsWith({ wick: "2" }).wick).toBe(0.002);
  expect(optionsWith({ wick: "thick" }).wick).toBeNull();
  expect(optionsWith({}).wick).toBeNull();
});

test("a moon without a direction, or one that cannot be read, stands where the model's own does", () => {
  expect(optionsWith({}, { moonDirection: "0 90" }).moon.direction?.[1]).toBe(-1);
  for (const moonDirection of ["", "east"]) {
    expect(optionsWith({}, { moonDirection }).moon.direction).toBeNull();
  }
});

test("the built-in models lie where the page says, else beside the module, if that has a folder", () => {
  const rootOf = (assetBase: string, module: string) =>
    assetRootOf({ assetBase, baseURI: "https://a.example/b/" } as ReflectedAttributes, module);
  const module = "https://cdn.example/dist/define.js";
  expect(rootOf("", module)).toBe("https://cdn.example/dist/");
  expect(rootOf("https://", module), "no address").toBe("https://cdn.example/dist/");
  for (const address of [module, "", "blob:https://a.example/1"]) {
    expect(rootOf("assets", address)).toBe("https://a.example/b/assets/");
  }
  expect(rootOf("", "blob:https://a.example/1")).toBe("");
});
