import { SETTINGS, type SettingName } from "../../src/settings.ts";

/** Texts that no attribute is meant to have. */
const NONSENSE: readonly string[] = [
  "",
  " ",
  "NaN",
  "-1",
  "-0",
  "1e999",
  "-1e999",
  "9007199254740993",
  "0x10",
  "1,5",
  "12 candles",
  "null",
  "undefined",
  "true",
  "false",
  "[object Object]",
  "<script>",
  "../../..",
  "http://",
  "data:",
  "blob:nothing",
  "🕯️",
  "\u0000",
  "٣",
  "constructor",
  "__proto__",
  "a".repeat(5000),
  "9".repeat(400),
];

interface Change {
  readonly name: SettingName;
  /** `null` takes the attribute away. */
  readonly value: string | null;
}

/** A number in [0, 1) that depends on its index alone. */
function chance(index: number): number {
  let hash = Math.imul(index ^ 0x9e3779b9, 0x85ebca6b);
  hash = Math.imul(hash ^ (hash >>> 13), 0xc2b2ae35);
  return ((hash ^ (hash >>> 16)) >>> 0) / 2 ** 32;
}

/** Changes of one to five attributes each, the same in every run: nonsense, legal values and numbers of any size. */
export function attributeValues(count: number): readonly (readonly Change[])[] {
  let drawn = 0;
  const pick = <T>(list: readonly T[]): T => list[Math.floor(chance(drawn++) * list.length)] as T;
  const names = Object.keys(SETTINGS) as SettingName[];
  const textFor = (name: SettingName): string | null => {
    const kind = chance(drawn++);
    const setting = SETTINGS[name];
    if (kind < 0.1) return null;
    if (kind < 0.25 && setting.kind === "choice") return pick<string>(setting.choices);
    if (kind < 0.4) return String((chance(drawn++) - 0.5) * 10 ** (chance(drawn++) * 20));
    return pick(NONSENSE);
  };
  return Array.from({ length: count }, () =>
    Array.from({ length: 1 + Math.floor(chance(drawn++) * 5) }, () => {
      const name = pick(names);
      return { name, value: textFor(name) };
    }),
  );
}
