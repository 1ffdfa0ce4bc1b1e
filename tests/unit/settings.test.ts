import { describe, expect, test } from "vitest";
import {
  FEATURE_MEANINGS,
  INSPECTION_MEANINGS,
  SETTING_MEANINGS,
} from "../../src/page/meanings.ts";
import {
  allFeatures,
  type ChoiceSetting,
  FEATURES,
  INSPECTIONS,
  type NumberSetting,
  parseChoice,
  parseIndices,
  parseNumber,
  SETTINGS,
} from "../../src/settings.ts";
import { attributeValues } from "../support/random-values.ts";

type Setting = (typeof SETTINGS)[keyof typeof SETTINGS];
const entries = Object.entries(SETTINGS) as [string, Setting][];
const numbers = entries.filter((entry): entry is [string, Setting & NumberSetting] => {
  return entry[1].kind === "number";
});
const choices = entries.filter((entry): entry is [string, Setting & ChoiceSetting] => {
  return entry[1].kind === "choice";
});

/** Texts that are no number at all. */
const GARBAGE = [
  "",
  " ",
  "garbage",
  "NaN",
  "Infinity",
  "-Infinity",
  "1e999",
  "--1",
  ".",
  "e5",
  "½",
];

test.each(Object.keys(SETTINGS))("%s is an attribute HTML can spell", (name) => {
  expect(name).toMatch(/^[a-z]+(-[a-z]+)*$/);
});

test("every attribute, technique and picture of a pass is explained in sentences, and nothing else is", () => {
  expect(Object.keys(SETTING_MEANINGS)).toEqual(Object.keys(SETTINGS));
  expect(Object.keys(FEATURE_MEANINGS)).toEqual(FEATURES);
  expect(Object.keys(INSPECTION_MEANINGS)).toEqual(INSPECTIONS);
  for (const meanings of [SETTING_MEANINGS, FEATURE_MEANINGS, INSPECTION_MEANINGS]) {
    for (const meaning of Object.values(meanings)) expect(meaning).toMatch(/^\p{Lu}.*\.$/su);
  }
});

test("a list of indices is read as far as it is one", () => {
  expect(parseIndices("0 2")).toEqual([0, 2]);
  expect(parseIndices(" 3,1\n3 , 12 ")).toEqual([3, 1, 12]);
  expect(parseIndices("-1 1.5 two 2 99999")).toEqual([2]);
  for (const text of GARBAGE) expect(parseIndices(text), text).toBeNull();
});

describe.each(numbers)("the number %s", (_, setting) => {
  const parse = (text: string | null) => parseNumber(setting, text);

  test("has a default within its range", () => {
    expect(setting.default).toBeGreaterThanOrEqual(setting.min);
    expect(setting.default).toBeLessThanOrEqual(setting.max);
    if (setting.integer) expect(Number.isInteger(setting.default)).toBe(true);
  });

  test("is its default when absent or no number", () => {
    expect(parse(null)).toBe(setting.default);
    for (const text of GARBAGE) expect(parse(text)).toBe(setting.default);
  });

  test("is the nearest legal value when out of range", () => {
    expect(parse(String(setting.max + 1))).toBe(setting.max);
    expect(parse("1e300")).toBe(setting.max);
    expect(parse(String(setting.min - 1))).toBe(setting.min);
    expect(parse("-1e300")).toBe(setting.min);
  });

  test("may stand amid white space and before a unit, as in HTML", () => {
    const legal = setting.integer ? Math.trunc((setting.min + setting.max) / 2) : setting.max / 2;
    expect(parse(` \n\t${legal} `)).toBe(legal);
    expect(parse(`${legal}px`)).toBe(legal);
  });

  test("survives the round trip through an attribute", () => {
    for (const value of [setting.min, setting.default, setting.max]) {
      expect(parse(String(value))).toBe(value);
    }
  });
});

test.each(numbers.filter(([, { integer }]) => integer))("%s is whole", (_, setting) => {
  expect(parseNumber(setting, "3.99")).toBe(3);
  expect(parseNumber(setting, "-0.5")).toBe(0);
});

test("a number without that demand keeps its fraction", () => {
  expect(parseNumber(SETTINGS.exposure, "-1.25")).toBe(-1.25);
});

describe.each(choices)("the choice %s", (_, setting) => {
  test("has a default among its words", () => {
    expect(setting.choices).toContain(setting.default);
    expect(new Set(setting.choices).size).toBe(setting.choices.length);
  });

  test("is each of its words, in any case and amid white space", () => {
    for (const word of setting.choices) {
      expect(parseChoice(setting, word)).toBe(word);
      expect(parseChoice(setting, `\t ${word.toUpperCase()}\n`)).toBe(word);
    }
  });

  test("is its default when absent or unknown", () => {
    for (const text of [null, ...GARBAGE, "constructor", "__proto__", setting.choices.join(" ")]) {
      expect(parseChoice(setting, text)).toBe(setting.default);
    }
  });
});

test("ten thousand rounds of random text leave every setting legal", () => {
  const named = new Set<string>();
  const isLegal = (name: keyof typeof SETTINGS, value: string | null) => {
    const setting: Setting = SETTINGS[name];
    if (setting.kind === "choice") {
      return (setting.choices as readonly string[]).includes(
        parseChoice<string>(setting as ChoiceSetting, value),
      );
    }
    if (setting.kind !== "number") return true; // any text is, and a flag is there or not
    const number = parseNumber(setting, value);
    const isWhole = !("integer" in setting) || Number.isInteger(number);
    return number >= setting.min && number <= setting.max && isWhole;
  };
  const illegal = attributeValues(10_000)
    .flat()
    .filter(({ name, value }) => {
      named.add(name);
      return !isLegal(name, value);
    });
  expect(illegal).toEqual([]);
  expect(named.size).toBe(entries.length);
});

test("the default look is physical", () => {
  expect(SETTINGS.look.default).toBe("physical");
});

describe("features", () => {
  test("are all on at first, and nobody shares them", () => {
    const features = allFeatures();
    expect(Object.keys(features)).toEqual(FEATURES);
    expect(Object.values(features).every((isOn) => isOn)).toBe(true);
    features.drift = false;
    expect(allFeatures().drift).toBe(true);
  });

  test("hold the rungs of the paper's Table 1", () => {
    expect(FEATURES).toEqual(
      expect.arrayContaining(["particles", "gradient", "attenuation", "drift"]),
    );
  });
});
