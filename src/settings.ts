/**
 * Every tunable of the element, once: the attribute's name, unit, range and default.
 *
 * The element, the page, the documentation and the tests read this table, and `page/meanings.ts` explains
 * it. A value that cannot be parsed or lies outside its range becomes the nearest legal value, or the
 * default, as with HTML's own attributes.
 */
export interface NumberSetting {
  readonly kind: "number";
  readonly default: number;
  readonly min: number;
  readonly max: number;
  readonly integer?: boolean;
  /** Of the attribute. */
  readonly unit: string;
}

export interface ChoiceSetting<Choice extends string = string> {
  readonly kind: "choice";
  readonly choices: readonly Choice[];
  readonly default: Choice;
}

export type Setting =
  | NumberSetting
  | ChoiceSetting
  | { readonly kind: "flag" }
  | { readonly kind: "text"; readonly default: string };

function choice<const Choice extends string>(
  choices: readonly [Choice, ...Choice[]],
): ChoiceSetting<Choice> {
  return { kind: "choice", choices, default: choices[0] };
}

function number(
  unit: string,
  [initial, min, max]: readonly [number, number, number],
): NumberSetting {
  return { kind: "number", unit, default: initial, min, max };
}

export const SETTINGS = {
  scene: choice(["room", "candle"]),
  look: choice(["physical", "paper", "original"]),
  src: { kind: "text", default: "" },
  quality: choice(["auto", "low", "medium", "high", "ultra"]),
  controls: { kind: "flag" },
  sensitivity: number("", [1, 0.1, 5]),
  motion: choice(["auto", "reduced", "full"]),
  paused: { kind: "flag" },
  seed: { ...number("", [1, 0, 0xffffffff]), integer: true },
  unlit: { kind: "flag" },
  "lit-wicks": { kind: "text", default: "" },
  wind: number("m/s", [0.05, 0, 5]),
  "wind-direction": number("degrees", [0, -360, 360]),
  gustiness: number("", [0.5, 0, 1]),
  wick: number("mm", [2, 1, 50]),
  moonlight: number("lx", [0.15, 0, 0.3]),
  "moon-direction": { kind: "text", default: "" },
  exposure: number("EV", [0, -8, 8]),
  particles: { ...number("", [0, 0, 1_000_000]), integer: true },
  "max-pixel-ratio": number("", [2, 0.25, 4]),
  "asset-base": { kind: "text", default: "" },
  loading: choice(["eager", "lazy"]),
  poster: { kind: "text", default: "" },
  alt: { kind: "text", default: "A burning candle" },
} as const satisfies Record<string, Setting>;

export type SettingName = keyof typeof SETTINGS;
export const SETTING_NAMES = Object.keys(SETTINGS) as readonly SettingName[];
export type Look = (typeof SETTINGS.look.choices)[number];
export type SceneName = (typeof SETTINGS.scene.choices)[number];
export type Quality = (typeof SETTINGS.quality.choices)[number];

/** Value of an attribute's property. */
export type SettingValue<One> =
  One extends ChoiceSetting<infer Choice>
    ? Choice
    : One extends { kind: "number" }
      ? number
      : One extends { kind: "flag" }
        ? boolean
        : string;

/** Name of an attribute's property. */
export type CamelCase<Name extends string> = Name extends `${infer Head}-${infer Tail}`
  ? `${Head}${Capitalize<CamelCase<Tail>>}`
  : Name;

export function camelCase<Name extends SettingName>(name: Name): CamelCase<Name> {
  return name.replace(/-(.)/g, (_, letter: string) => letter.toUpperCase()) as CamelCase<Name>;
}

/** Parses an attribute's text; `null` is an absent attribute. */
export function parseNumber(setting: NumberSetting, text: string | null): number {
  const value = Number.parseFloat(text ?? "");
  if (!Number.isFinite(value)) return setting.default;
  const inRange = Math.min(Math.max(value, setting.min), setting.max);
  return setting.integer ? Math.trunc(inRange) : inRange;
}

export function parseChoice<Choice extends string>(
  setting: ChoiceSetting<Choice>,
  text: string | null,
): Choice {
  const word = text?.trim().toLowerCase();
  return setting.choices.find((known) => known === word) ?? setting.default;
}

/** Parses a list of indices, such as "0 2"; null where there is none in it. */
export function parseIndices(text: string): readonly number[] | null {
  const words = text.split(/[\s,]+/).filter((word) => /^\d{1,4}$/.test(word));
  return words.length > 0 ? [...new Set(words.map(Number))] : null;
}

const PARTICLE_FEATURES = ["particles", "core"] as const;
const PAPER_FEATURES = ["hazeLayer", "gradient", "attenuation", "drift", "flicker"] as const;
const MODEL_FEATURES = ["normalMaps", "candle"] as const;
const PHYSICAL_FEATURES = [
  "volume",
  "shadows",
  "indirect",
  "specular",
  "translucency",
  "haze",
  "smoke",
  "sparks",
  "dust",
  "bloom",
  "autoExposure",
  "adaptation",
  "toneMap",
] as const;

/** Techniques that can be switched off, one at a time, to see their effect and their cost. */
export const FEATURES = [
  ...PARTICLE_FEATURES,
  ...PAPER_FEATURES,
  ...MODEL_FEATURES,
  ...PHYSICAL_FEATURES,
] as const;
export type Feature = (typeof FEATURES)[number];

/** The techniques of a look. */
export function featuresOf(look: Look): readonly Feature[] {
  const features: Readonly<Record<Look, readonly Feature[]>> = {
    physical: [...MODEL_FEATURES, ...PHYSICAL_FEATURES],
    paper: [...PARTICLE_FEATURES, ...PAPER_FEATURES, ...MODEL_FEATURES],
    original: [...PARTICLE_FEATURES, "candle"],
  };
  return features[look];
}
export type Features = Record<Feature, boolean>;

export function allFeatures(): Features {
  return Object.fromEntries(FEATURES.map((name) => [name, true])) as Features;
}

/** Field of view across the frame's shorter side, radians, unless the page sets another. */
export const FIELDS_OF_VIEW: Readonly<Record<Look, number>> = {
  physical: (56 * Math.PI) / 180,
  paper: Math.PI / 4,
  original: Math.PI / 4,
};

/** Outputs of passes that can be shown instead of the picture, in the physical look: `element.inspect = "depth"`. */
export const INSPECTIONS = [
  "picture",
  "radiance",
  "exposure",
  "bloom",
  "normals",
  "depth",
  "shadow-cube",
  "irradiance-volume",
  "haze",
  "soot",
  "blue",
  "temperature",
] as const;
export type Inspection = (typeof INSPECTIONS)[number];
