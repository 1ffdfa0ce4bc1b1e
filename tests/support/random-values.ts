import { SETTINGS, type SettingName } from "../../src/settings.ts";
import { pcg, unit } from "../../src/world/random.ts";

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

/** Changes of one to five attributes each, the same in every run: nonsense, legal values and numbers of any size. */
export function attributeValues(count: number): readonly (readonly Change[])[] {
  let drawn = 0;
  const chance = () => unit(pcg(drawn++));
  const pick = <T>(list: readonly T[]): T => list[Math.floor(chance() * list.length)] as T;
  const names = Object.keys(SETTINGS) as SettingName[];
  const textFor = (name: SettingName): string | null => {
    const kind = chance();
    const setting = SETTINGS[name];
    if (kind < 0.1) return null;
    if (kind < 0.25 && setting.kind === "choice") return pick<string>(setting.choices);
    if (kind < 0.4) return String((chance() - 0.5) * 10 ** (chance() * 20));
    return pick(NONSENSE);
  };
  return Array.from({ length: count }, () =>
    Array.from({ length: 1 + Math.floor(chance() * 5) }, () => {
      const name = pick(names);
      return { name, value: textFor(name) };
    }),
  );
}
