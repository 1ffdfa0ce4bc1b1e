/**
 * Types of the element's attributes, properties and listeners in templates, for `candle-flame/react`, `/vue` and
 * `/svelte`.
 */
import type { CandleFlameElement, CandleFlameEventMap } from "./candle-flame-element.js";
import type { CamelCase, SETTINGS, SettingName, SettingValue } from "./settings.js";

type Settings = typeof SETTINGS;

/** As text, in the page's HTML. */
type Text<Setting> = Setting extends { kind: "number" }
  ? `${number}`
  : Setting extends { kind: "flag" }
    ? ""
    : never;

/** The attributes, by the names that HTML has for them. */
export type CandleFlameAttributes = {
  [Name in SettingName]?: SettingValue<Settings[Name]> | Text<Settings[Name]> | undefined;
};

/** The attributes' properties, and those that have no attribute and can be written. */
export type CandleFlameProperties = {
  [Name in SettingName as CamelCase<Name>]?:
    | SettingValue<Settings[Name]>
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
