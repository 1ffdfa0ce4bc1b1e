import type { CandleFlameElement } from "../candle-flame-element.js";
import { SETTINGS, type SettingName } from "../settings.js";
import { SETTING_MEANINGS } from "./meanings.js";
import { type Control, controlOf, type Setting, settingRow } from "./setting-row.js";

/** Settings that can have a control here. */
type Shown = Exclude<SettingName, "max-pixel-ratio" | "asset-base">;

/** How fine a slider is, in the setting's own unit. */
const SLIDER_STEP = 0.1;
const SLIDER_STEPS: Readonly<Partial<Record<Shown, number>>> = {
  wind: 0.05,
  "wind-direction": 5,
  gustiness: 0.05,
  wick: 0.5,
};

/** A control for each of some settings, made from the table of settings. */
export class SettingsForm {
  readonly #element: CandleFlameElement;
  readonly #controls = new Map<Shown, Control>();
  readonly #outputs = new Map<Shown, HTMLOutputElement>();

  /** @param form where the controls go; its id begins theirs */
  constructor(element: CandleFlameElement, form: HTMLElement, names: readonly Shown[]) {
    this.#element = element;
    for (const name of names) form.append(this.#row(`${form.id}-${name}`, name));
    this.refresh();
  }

  #row(id: string, name: Shown): HTMLElement {
    const setting: Setting = SETTINGS[name];
    const control = controlOf(setting, SLIDER_STEPS[name] ?? SLIDER_STEP);
    const isSlider = setting.kind === "number" && !setting.integer;
    if (isSlider) control.setAttribute("type", "range");
    control.addEventListener(isSlider ? "input" : "change", () => {
      this.#element.setAttribute(name, control.value);
      this.refresh(); // what the element made of it
    });
    this.#controls.set(name, control);
    const meaning = SETTING_MEANINGS[name];
    const row = settingRow(control, { id, name: name.replace("-", " "), meaning });
    row.className = "setting";
    if (isSlider) {
      const output = document.createElement("output");
      output.htmlFor.add(id);
      this.#outputs.set(name, output);
      control.after(output);
    }
    return row;
  }

  refresh(): void {
    for (const [name, control] of this.#controls) control.value = this.#text(name);
    for (const [name, output] of this.#outputs) {
      const setting: Setting = SETTINGS[name];
      const unit = setting.kind === "number" ? setting.unit : "";
      output.value = `${this.#text(name)}${unit === "degrees" ? "°" : ` ${unit}`}`.trim();
    }
  }

  #text(name: Shown): string {
    return String(this.#element[name === "wind-direction" ? "windDirection" : name]);
  }
}
