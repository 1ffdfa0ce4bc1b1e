import { beforeAll, expect, test } from "vitest";
import {
  FAINT,
  MOST_SECTIONS,
  opticalDepth,
  setSections,
} from "../../../../src/render/volumetric/smoke-sections.ts";
import { advance } from "../../../../src/world/advance.ts";
import { createPlume } from "../../../../src/world/air/plume.ts";
import { blow } from "../../../../src/world/commands.ts";
import { LINES, ROWS, SMOKE_FLOATS, Smoke } from "../../../../src/world/particles/smoke.ts";
import { STILL } from "../../../../src/world/player/intent.ts";
import type { World } from "../../../../src/world/world.ts";
import { LONE_CANDLE_SETUP } from "../../../../src/world/world-setup.ts";
import { createWorld } from "../../../support/world.ts";

type Vector = readonly [number, number, number];

const sum = (a: Vector, b: Vector): Vector => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const times = (a: Vector, factor: number): Vector => [a[0] * factor, a[1] * factor, a[2] * factor];
const way = (a: Vector, b: Vector): Vector => sum(b, times(a, -1));
const length = (a: Vector) => Math.max(Math.hypot(...a), 1e-7);

function smokeOf({ plume }: World): Smoke {
  if (!plume) throw new Error("There is no hot air.");
  return plume.smoke;
}

function parcel({ parcels, newest, count }: Smoke, line: number, age: number): Vector {
  const row = (newest - Math.min(Math.max(age, 0), count - 1) + ROWS) % ROWS;
  const at = (row * LINES + line) * SMOKE_FLOATS;
  return [parcels[at] ?? 0, parcels[at + 1] ?? 0, parcels[at + 2] ?? 0];
}

/** `direction` of volumetric/smoke.vert. */
function direction(before: Vector, here: Vector, after: Vector): Vector {
  const [a, b] = [way(before, here), way(here, after)];
  const [lengthA, lengthB] = [length(a), length(b)];
  const tangent = sum(times(a, lengthB / lengthA), times(b, lengthA / lengthB));
  return times(tangent, 1 / length(tangent));
}

/** `place` of the same. */
function placeOn(smoke: Smoke, line: number, section: number): Vector {
  const age = Math.min(Math.floor(section), smoke.count - 2);
  const t = section - age;
  const s = 1 - t;
  const at = (offset: number) => parcel(smoke, line, age + offset);
  const chord = length(way(at(0), at(1)));
  const begin = times(direction(at(-1), at(0), at(1)), chord * t * s * s);
  const end = times(direction(at(0), at(1), at(2)), -chord * t * t * s);
  const between = sum(times(at(0), (1 + 2 * t) * s * s), times(at(1), (3 - 2 * t) * t * t));
  return sum(between, sum(begin, end));
}

/** Places where the pieces of each line end, of those that are seen. */
function lines(smoke: Smoke): Vector[][] {
  const ends = new Float32Array(MOST_SECTIONS);
  const pieces = setSections(ends, smoke);
  const isSeen = (line: number, section: number) =>
    [Math.floor(section), Math.ceil(section)].some((age) => {
      const row = (smoke.newest - age + ROWS) % ROWS;
      return opticalDepth(smoke.parcels, (row * LINES + line) * SMOKE_FLOATS) > FAINT;
    });
  const sections = [...ends.subarray(0, pieces + 1)];
  return Array.from({ length: LINES }, (_, line) => {
    const hidden = sections.findIndex((section) => !isSeen(line, section));
    const seen = sections.slice(0, hidden < 0 ? sections.length : hidden);
    return seen.map((section) => placeOn(smoke, line, section));
  });
}

let after: World[] = [];
beforeAll(() => {
  // 0.1, 0.3 and 0.8 s after a breath has put it out.
  after = [0.4, 0.6, 1.1].map((seconds) => {
    const world = createWorld("physical", 1, { setup: LONE_CANDLE_SETUP, createPlume });
    blow(world, 1);
    advance(world, STILL, seconds);
    return world;
  });
});

test("smoke in a breath is drawn in pieces of 3 cm at most, the first ones by the wick in millimetres", () => {
  for (const world of after) {
    const longest = lines(smokeOf(world)).map((line) =>
      line.slice(1).map((end, i) => Math.hypot(...way(line[i] ?? end, end))),
    );
    for (const pieces of longest) {
      expect(Math.max(...pieces)).toBeLessThan(0.03);
      expect(pieces[0]).toBeLessThan(0.003);
    }
  }
});

test("smoke has no corners of more than 40 degrees where its pieces are seen", () => {
  for (const world of after) {
    const angles = lines(smokeOf(world)).flatMap((line) =>
      line.slice(1, -1).map((here, i) => {
        const a = way(line[i] ?? here, here);
        const b = way(here, line[i + 2] ?? here);
        if (Math.min(length(a), length(b)) < 0.002) return 0;
        const cosine = (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / (length(a) * length(b));
        return (Math.acos(Math.min(cosine, 1)) * 180) / Math.PI;
      }),
    );
    expect(Math.max(...angles)).toBeLessThan(40);
  }
});

test("sections run from the youngest row to the oldest and end with each row on the way, however many there are", () => {
  const smoke = new Smoke(1);
  smoke.count = ROWS;
  // Parcels anywhere in ten metres: each piece would be divided.
  for (let i = 0; i < smoke.parcels.length; i++) smoke.parcels[i] = (i * 7919) % 10;
  const ends = new Float32Array(MOST_SECTIONS);
  const pieces = setSections(ends, smoke);
  expect(pieces).toBeLessThan(MOST_SECTIONS);
  expect(pieces).toBeGreaterThan(ROWS);
  const used = [...ends.subarray(0, pieces + 1)];
  expect(used.toSorted((a, b) => a - b)).toEqual(used);
  expect(used.filter(Number.isInteger)).toEqual([...Array(ROWS).keys()]);
});
