import { expect, test } from "vitest";
import { SETTINGS } from "../../../src/settings.ts";
import { manifest } from "../../../tools/elements-manifest.ts";

test("the manifest names each attribute, its type and its default", () => {
  const [module] = manifest().modules;
  const [declaration] = module?.declarations ?? [];
  const attributes = declaration?.attributes ?? [];
  expect(attributes.map(({ name }) => name)).toEqual(Object.keys(SETTINGS));
  const named = (name: string) => attributes.find((attribute) => attribute.name === name);
  expect(named("scene")).toMatchObject({ type: { text: '"room" | "candle"' }, default: '"room"' });
  expect(named("max-pixel-ratio")).toMatchObject({
    fieldName: "maxPixelRatio",
    type: { text: "number" },
    default: "2",
  });
  expect(named("paused")).toMatchObject({ type: { text: "boolean" } });
});
