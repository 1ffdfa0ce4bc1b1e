import type { CandleFlameElement } from "../candle-flame-element.js";
import { camelCase, SETTINGS, type Setting, type SettingName } from "../settings.js";
import { followAttributes } from "./follow-attributes.js";
import { SETTING_MEANINGS } from "./meanings.js";
import { showValue } from "./show-value.js";

export type Control = HTMLInputElement | HTMLSelectElement;

/** How fine a slider is, in the setting's own unit. */
const SLIDER_STEP = 0.1;
const SLIDER_STEPS: Readonly<Partial<Record<SettingName, number>>> = {
  wind: 0.05,
  "wind-direction": 5,
  gustiness: 0.05,
  wick: 0.5,
  moonlight: 0.01,
};

/**
 * Adds a control for each of some settings, made from the table of settings. It shows the element's values.
 *
 * @param form where the controls go; its id begins theirs
 */
export function addSettings(
  element: CandleFlameElement,
  form: HTMLElement,
  names: readonly SettingName[],
): void {
  for (const name of names) addSetting(element, form, name);
}

function addSetting(element: CandleFlameElement, form: HTMLElement, name: SettingName): void {
  const setting: Setting = SETTINGS[name];
  const step = SLIDER_STEPS[name] ?? SLIDER_STEP;
  const control = addRow(form, name, name.replace("-", " "), SETTING_MEANINGS[name], step);
  const isSlider = setting.kind === "number" && !setting.integer;
  control.addEventListener(isSlider ? "input" : "change", () => {
    element.setAttribute(name, control.value);
  });
  const output = document.createElement("output");
  if (isSlider) {
    control.setAttribute("type", "range");
    output.htmlFor.add(control.id);
    control.after(output);
  }
  followAttributes(element, [name], () => {
    const text = String(element[camelCase(name)]);
    control.value = text;
    if (isSlider) showValue(control, output, withUnit(text, setting.unit));
  });
}

function withUnit(text: string, unit: string): string {
  return `${text}${unit === "degrees" ? "°" : ` ${unit}`}`.trim();
}

/**
 * Adds a setting's row to a form: label, control at its default, and meaning.
 *
 * @param form its id begins the control's
 * @param step of numbers that need not be whole
 */
export function addRow(
  form: HTMLElement,
  name: SettingName,
  label: string,
  meaning: string,
  step: number | "any",
): Control {
  const control = controlOf(SETTINGS[name], step);
  control.id = `${form.id}-${name}`;
  const row = document.createElement("div");
  row.className = "setting";
  const term = document.createElement("label");
  term.htmlFor = control.id;
  term.textContent = label;
  const sentence = document.createElement("p");
  sentence.id = `${control.id}-meaning`;
  sentence.textContent = meaning;
  control.setAttribute("aria-describedby", sentence.id);
  row.append(term, control, sentence);
  form.append(row);
  return control;
}

function controlOf(setting: Setting, step: number | "any"): Control {
  if (setting.kind === "choice") {
    const select = document.createElement("select");
    for (const choice of setting.choices) select.add(new Option(choice, choice));
    return select;
  }
  const input = document.createElement("input");
  input.type = { flag: "checkbox", number: "number", text: "text" }[setting.kind];
  if (setting.kind === "number") {
    input.min = String(setting.min);
    input.max = String(setting.max);
    input.step = setting.integer ? "1" : String(step);
  }
  if (setting.kind !== "flag") input.value = String(setting.default);
  return input;
}
