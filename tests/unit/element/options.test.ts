import { expect, test } from "vitest";
import { optionsOf } from "../../../src/element/options.ts";
import type { ReflectedAttributes } from "../../../src/element/reflected-attributes.ts";

test("for visitors who want less motion the wind blows without gusts", () => {
  const gustinessOf = (motion: "reduced" | "full") => {
    const attributes = { motion, wind: 1, windDirection: 0, gustiness: 0.5, litWicks: "" };
    const element = { ...attributes, moonDirection: "", getAttribute: () => null };
    return optionsOf(element as unknown as ReflectedAttributes, "physical").wind.gustiness;
  };
  expect(gustinessOf("full")).toBe(0.5);
  expect(gustinessOf("reduced")).toBe(0);
});
