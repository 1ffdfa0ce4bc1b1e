import { SETTING_NAMES, SETTINGS, type SettingName } from "../../settings.js";

/** Markup of an element with these attributes; defaults are left out. */
export function tagOf(attributes: Readonly<Partial<Record<SettingName, string>>>): string {
  const words = SETTING_NAMES.flatMap((name) => {
    const text = attributes[name];
    if (text === undefined) return [];
    const setting = SETTINGS[name];
    if (setting.kind === "flag") return [name];
    // With a model, these are "auto" by default.
    const isOfModel = attributes.src && (name === "wick" || name === "moonlight");
    if (!isOfModel && text === String(setting.default)) return [];
    return [`${name}="${text.replaceAll("&", "&amp;").replaceAll('"', "&quot;")}"`];
  });
  return `<${["candle-flame", ...words].join(" ")}></candle-flame>`;
}
