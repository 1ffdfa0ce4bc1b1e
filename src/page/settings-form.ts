import type { CandleFlameElement } from "../candle-flame-element.js";
import { SETTINGS, type SettingName } from "../settings.js";
import { SETTING_MEANINGS } from "./meanings.js";
import { controlOf, type Setting, settingRow } from "./setting-row.js";

/** Settings that can have a control here. */
type Shown = Exclude<SettingName, "max-pixel-ratio" | "asset-base" | "lit-wicks">;

/** Properties of attributes that have a hyphen. */
const PROPERTIES: Readonly<Partial<Record<Shown, keyof CandleFlameElement>>> = {
  "wind-direction": "windDirection",
  "moon-direction": "moonDirection",
};

/** How fine a slider is, in the setting's own unit. */
const SLIDER_STEP = 0.1;
const SLIDER_STEPS: Readonly<Partial<Record<Shown, number>>> = {
  wind: 0.05,
  "wind-direction": 5,
  gustiness: 0.05,
  wick: 0.5,
  moonlight: 0.01,
};

/**
 * Adds a control for each of some settings, made from the table of settings.
 *
 * @param form where the controls go; its id begins theirs
 * @returns what shows the element's values again
 */
export function addSettings(
  element: CandleFlameElement,
  form: HTMLElement,
  names: readonly Shown[],
): () => void {
  const refreshes = names.map((name) => addSetting(element, form, name, () => refresh()));
  const refresh = () => {
    for (const refreshOne of refreshes) refreshOne();
  };
  refresh();
  return refresh;
}

function addSetting(
  element: CandleFlameElement,
  form: HTMLElement,
  name: Shown,
  onChange: () => void,
): () => void {
  const id = `${form.id}-${name}`;
  const setting: Setting = SETTINGS[name];
  const control = controlOf(setting, SLIDER_STEPS[name] ?? SLIDER_STEP);
  const isSlider = setting.kind === "number" && !setting.integer;
  control.addEventListener(isSlider ? "input" : "change", () => {
    element.setAttribute(name, control.value);
    onChange(); // the element may have changed the value
  });
  const meaning = SETTING_MEANINGS[name];
  const row = settingRow(control, { id, name: name.replace("-", " "), meaning });
  row.className = "setting";
  form.append(row);
  const text = () => String(element[PROPERTIES[name] ?? (name as keyof CandleFlameElement)]);
  const output = document.createElement("output");
  if (isSlider) {
    control.setAttribute("type", "range");
    output.htmlFor.add(id);
    control.after(output);
  }
  const unit = isSlider ? setting.unit : "";
  return () => {
    control.value = text();
    output.value = `${text()}${unit === "degrees" ? "°" : ` ${unit}`}`.trim();
  };
}
