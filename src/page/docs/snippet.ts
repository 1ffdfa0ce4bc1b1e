import { SETTINGS, type SettingName } from "../../settings.js";

/** The line of HTML that an element with these attributes is; what is at its default is not said. */
export function tagOf(attributes: Readonly<Partial<Record<SettingName, string>>>): string {
  const words = (Object.keys(SETTINGS) as SettingName[]).flatMap((name) => {
    const text = attributes[name];
    if (text === undefined) return [];
    const setting = SETTINGS[name];
    if (setting.kind === "flag") return [name];
    if (text === String(setting.default)) return [];
    return [`${name}="${text.replaceAll("&", "&amp;").replaceAll('"', "&quot;")}"`];
  });
  return `<${["candle-flame", ...words].join(" ")}></candle-flame>`;
}
