import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import type { CandleFlameEventMap } from "../../../src/candle-flame-element.ts";
import type { StateName } from "../../../src/element/custom-states.ts";
import { SETTINGS } from "../../../src/settings.ts";
import { manifest } from "../../../tools/elements-manifest.ts";

const { modules } = await manifest();
const [element] = modules.flatMap(({ declarations }) => declarations ?? []);
const namesOf = (list: readonly { name: string }[] = []) => list.map(({ name }) => name).toSorted();

test("package.json names the manifest, and the manifest modules, where the package has them", () => {
  const { customElements, exports } = JSON.parse(readFileSync("package.json", "utf8"));
  expect(`./${customElements}`).toBe(exports["./custom-elements.json"]);
  const [element, define] = [exports["."].default, exports["./define"].default];
  expect(modules.map(({ path }) => `./${path}`)).toEqual([element, define]);
  for (const { declaration } of modules.flatMap((module) => module.exports)) {
    expect(`./${declaration.module}`).toBe(element);
  }
});

test("the manifest names each attribute, its type and its default", () => {
  const attributes = element?.attributes ?? [];
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

test("the manifest describes each event, state, property and method, and none of those inside", () => {
  const events: Record<keyof CandleFlameEventMap, true> = {
    progress: true,
    load: true,
    error: true,
    play: true,
    pause: true,
    light: true,
    extinguish: true,
    place: true,
    take: true,
    enter: true,
    leave: true,
    qualitychange: true,
    camerachange: true,
    contextlost: true,
    contextrestored: true,
  };
  const states: Record<StateName, true> = {
    loading: true,
    lit: true,
    walking: true,
    playing: true,
    alone: true,
  };
  expect(namesOf(element?.events)).toEqual(Object.keys(events).toSorted());
  expect(namesOf(element?.cssStates)).toEqual(Object.keys(states).toSorted());
  const {
    events: eventEntries,
    slots,
    cssParts,
    cssStates,
    cssProperties,
    members,
  } = element ?? {};
  const lists = [eventEntries, slots, cssParts, cssStates, cssProperties, members];
  for (const entry of lists.flatMap((list) => list ?? [])) {
    expect(entry.description, entry.name).toMatch(/^\S.*\.$/);
    expect(entry.name).toMatch(/^(--)?[a-z][\w-]*$/i);
  }
  const step = members?.find(({ name }) => name === "step");
  expect(step).toMatchObject({ kind: "method", parameters: [{ type: { text: "number" } }] });
  expect(members?.find(({ name }) => name === "held")).toMatchObject({ readonly: true });
  expect(element).toMatchObject({ tagName: "candle-flame", customElement: true });
});

test("docs/embedding.md names all that the manifest does, and nothing else", () => {
  const page = readFileSync("docs/embedding.md", "utf8");
  const namesBetween = (from: string, to: string) => {
    const text = page.slice(page.indexOf(from), page.indexOf(to, page.indexOf(from)));
    return [...text.matchAll(/`(--)?([a-z][\w-]*)(\([^`]*\))?`/gi)]
      .map(([, dashes = "", name = ""]) => dashes + name)
      .toSorted();
  };
  const members = element?.members.filter(({ name }) =>
    element.attributes.every(({ fieldName }) => fieldName !== name),
  );
  expect(namesBetween("Methods and properties:", "\n\n")).toEqual(namesOf(members));
  expect(namesBetween("Events:", "None bubbles")).toEqual(namesOf(element?.events));
  expect(namesBetween("Slots:", ";")).toEqual(namesOf(element?.slots));
  expect(namesBetween("Parts:", "\n")).toEqual(namesOf(element?.cssParts));
  expect(namesBetween("Custom properties:", "\n")).toEqual(namesOf(element?.cssProperties));
  expect(namesBetween("States:", "\n")).toEqual(namesOf(element?.cssStates));
});

test("docs/embedding.md has a row for each attribute, with its default", () => {
  const page = readFileSync("docs/embedding.md", "utf8");
  const rows = [...page.matchAll(/^\| `([\w-]+)` \|([^|]*)\|/gm)].map(
    ([, name = "", values = ""]) => [name, values.trim()] as const,
  );
  expect(rows.map(([name]) => name).toSorted()).toEqual(Object.keys(SETTINGS).toSorted());
  for (const [name, values] of rows) {
    const setting: { kind: string; default?: unknown; choices?: readonly string[] } =
      SETTINGS[name as keyof typeof SETTINGS];
    const said = [...values.matchAll(/`([^`]*)`/g)].map(([, value]) => value);
    if (setting.kind === "flag") expect(values, name).toBe("boolean");
    else if (setting.kind === "choice") expect(said, name).toEqual(setting.choices);
    else if (setting.kind === "number") expect(said, name).toEqual([String(setting.default)]);
    else expect(said, name).toEqual([]);
  }
});
