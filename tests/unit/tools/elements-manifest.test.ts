import { readFileSync } from "node:fs";
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

test("the README names all that the manifest does, and nothing that it does not", () => {
  const [face] = manifest().modules.flatMap(({ declarations }) => declarations ?? []);
  const readme = readFileSync("README.md", "utf8");
  const told = (from: string, to: string) => {
    const text = readme.slice(readme.indexOf(from), readme.indexOf(to, readme.indexOf(from)));
    return [...text.matchAll(/`(--)?([a-z][\w-]*)(\([^`]*\))?`/gi)].map(
      ([, dashes = "", name = ""]) => (dashes ? dashes + name : name),
    );
  };
  const rows = readme
    .slice(readme.indexOf("| attribute |"), readme.indexOf("Methods and properties:"))
    .split("\n")
    .flatMap((row) =>
      [...(row.split("|")[1] ?? "").matchAll(/`([\w-]+)`/g)].map(([, name]) => name),
    );
  const namesOf = (list: readonly { name: string }[] = []) => list.map(({ name }) => name).sort();
  const attributes = namesOf(face?.attributes);
  expect(rows.sort()).toEqual(attributes);
  const members = face?.members.filter(({ name }) =>
    face.attributes.every(({ fieldName }) => fieldName !== name),
  );
  expect(told("Methods and properties:", "Events:").sort()).toEqual(namesOf(members));
  expect(told("Events:", "A value that").sort()).toEqual(namesOf(face?.events));
  expect(told("Slots:", ", each in place").sort()).toEqual(namesOf(face?.slots));
  expect(told("Parts:", "Custom properties:").sort()).toEqual(namesOf(face?.cssParts));
  expect(told("Custom properties:", "States:").sort()).toEqual(namesOf(face?.cssProperties));
  expect(told("States:", "Nothing is drawn").sort()).toEqual(namesOf(face?.cssStates));
});
