import { existsSync } from "node:fs";
import { resolve } from "node:path";
import { describe, expect, test } from "vitest";
import { GROUPS } from "../../src/world/particles/particle-layer.ts";
import { codeOf, filesIn, textOf } from "./sources.ts";

const ROOT = resolve(import.meta.dirname, "../../shaders");
const STAGES = filesIn("shaders", /\.(vert|frag)$/);
const INCLUDED = filesIn("shaders", /\.glsl$/);
const ALL = [...STAGES, ...INCLUDED];

const includesOf = (file: string) =>
  [...textOf(file).matchAll(/^[ \t]*#include\s+"([^"]+)"/gm)].map(([, name = ""]) => name);

test("there are shaders to look at", () => {
  expect(STAGES.length).toBeGreaterThan(7);
  expect(INCLUDED.length).toBeGreaterThan(4);
});

describe.each(ALL)("%s", (file) => {
  test("includes only what there is", () => {
    for (const name of includesOf(file)) expect(existsSync(resolve(ROOT, name)), name).toBe(true);
    expect(codeOf(file).match(/#\s*include/g)?.length ?? 0).toBe(includesOf(file).length);
  });

  test("takes no chances from the sine, which differs between renderers", () => {
    expect(codeOf(file)).not.toMatch(/fract\s*\(\s*(sin|cos)\s*\(/);
  });

  test("does not include itself, not even by detour", () => {
    const reached = new Set(includesOf(file));
    for (const name of reached) for (const next of includesOf(`shaders/${name}`)) reached.add(next);
    expect(reached).not.toContain(file.replace("shaders/", ""));
  });
});

test.each(STAGES)("%s is a whole stage in GLSL ES 3.00, with a sentence about itself", (file) => {
  expect(textOf(file)).toMatch(/^#version 300 es\n\/\/ \S/);
  expect(codeOf(file).match(/\bvoid main\(\)/g)).toHaveLength(1);
});

test.each(INCLUDED)("%s is never compiled alone", (file) => {
  expect(textOf(file)).toMatch(/^\/\/ \S/);
  expect(codeOf(file)).not.toMatch(/#version|\bvoid main\(/);
  expect(STAGES.concat(INCLUDED).some((other) => includesOf(other).includes(file.slice(8)))).toBe(
    true,
  );
});

test("the kernel and its twin count the same groups, and the same ticks in a pass", () => {
  const kernel = codeOf("shaders/particles/kernel.glsl");
  const system = codeOf("src/render/volumetric/particle-system.ts");
  expect(/\bGROUPS = (\d+)u;/.exec(kernel)?.[1]).toBe(String(GROUPS));
  const ticks = /\bMAX_TICKS = (\d+);/;
  expect(ticks.exec(kernel)?.[1]).toMatch(/^\d+$/);
  expect(ticks.exec(kernel)?.[1]).toBe(ticks.exec(system)?.[1]);
});
