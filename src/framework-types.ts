/**
 * What frameworks may write in a template's tag. Types only: `candle-flame/react`, `/vue` and `/svelte` build
 * on them.
 */
import type { CandleFlameElement, CandleFlameEventMap } from "./candle-flame-element.js";
import type { SETTINGS, SettingName } from "./settings.js";

type Settings = typeof SETTINGS;

type Value<Setting> = Setting extends { kind: "choice"; choices: readonly (infer Choice)[] }
  ? Choice
  : Setting extends { kind: "number" }
    ? number
    : Setting extends { kind: "flag" }
      ? boolean
      : string;

/** As text, in the page's HTML. */
type Text<Setting> = Setting extends { kind: "number" }
  ? `${number}`
  : Setting extends { kind: "flag" }
    ? ""
    : never;

type CamelCase<Name extends string> = Name extends `${infer Head}-${infer Tail}`
  ? `${Head}${Capitalize<CamelCase<Tail>>}`
  : Name;

/** The attributes, by the names that HTML has for them. */
export type CandleFlameAttributes = {
  [Name in SettingName]?: Value<Settings[Name]> | Text<Settings[Name]> | undefined;
};

/** The attributes' properties, and those that have no attribute and can be written. */
export type CandleFlameProperties = {
  [Name in SettingName as CamelCase<Name>]?:
    | Value<Settings[Name]>
    | Text<Settings[Name]>
    | undefined;
} & {
  lit?: boolean | undefined;
  camera?: Partial<CandleFlameElement["camera"]> | undefined;
  features?: Partial<CandleFlameElement["features"]> | undefined;
  inspect?: CandleFlameElement["inspect"] | undefined;
};

/** Listeners, as DOM spells them: `onprogress`. */
export type CandleFlameListeners = {
  [Type in keyof CandleFlameEventMap as `on${Type}`]?:
    | ((event: CandleFlameEventMap[Type]) => void)
    | undefined;
};
