import type { CandleFlameElement } from "../candle-flame-element.js";
import { type ChoiceSetting, type NumberSetting, SETTINGS } from "../settings.js";
import { SETTING_MEANINGS } from "./meanings.js";

/** Those that have a control. */
type Shown =
  | "look"
  | "quality"
  | "seed"
  | "wind"
  | "wind-direction"
  | "gustiness"
  | "wick"
  | "exposure"
  | "particles"
  | "sensitivity"
  | "motion";

/** How fine a slider is, in the setting's own unit. */
const SLIDER_STEP = 0.1;
const SLIDER_STEPS: Readonly<Partial<Record<Shown, number>>> = {
  wind: 0.05,
  "wind-direction": 5,
  gustiness: 0.05,
  wick: 0.5,
};

type Control = HTMLInputElement | HTMLSelectElement;

/** A control for each of some settings, made from the table of settings. */
export class SettingsForm {
  readonly #element: CandleFlameElement;
  readonly #controls = new Map<Shown, Control>();
  readonly #outputs = new Map<Shown, HTMLOutputElement>();

  /** @param form where the controls go; its id begins theirs */
  constructor(element: CandleFlameElement, form: HTMLElement, names: readonly Shown[]) {
    this.#element = element;
    for (const name of names) form.append(this.#row(form.id, name, SETTINGS[name]));
    this.refresh();
  }

  #row(form: string, name: Shown, setting: ChoiceSetting | NumberSetting): HTMLElement {
    const row = document.createElement("div");
    row.className = "setting";
    const label = document.createElement("label");
    label.htmlFor = `${form}-${name}`;
    label.textContent = name.replace("-", " ");
    const control =
      setting.kind === "choice"
        ? select(setting.choices)
        : numberInput(setting, SLIDER_STEPS[name] ?? SLIDER_STEP);
    control.id = label.htmlFor;
    const meaning = document.createElement("p");
    meaning.id = `${form}-${name}-meaning`;
    meaning.textContent = SETTING_MEANINGS[name];
    control.setAttribute("aria-describedby", meaning.id);
    control.addEventListener(control.type === "range" ? "input" : "change", () => {
      this.#element.setAttribute(name, control.value);
      this.refresh(); // what the element made of it
    });
    this.#controls.set(name, control);
    row.append(label, control);
    if (control.type === "range") {
      const output = document.createElement("output");
      output.htmlFor.add(control.id);
      this.#outputs.set(name, output);
      row.append(output);
    }
    row.append(meaning);
    return row;
  }

  refresh(): void {
    for (const [name, control] of this.#controls) control.value = this.#text(name);
    for (const [name, output] of this.#outputs) {
      const setting: ChoiceSetting | NumberSetting = SETTINGS[name];
      const unit = setting.kind === "number" ? setting.unit : "";
      output.value = `${this.#text(name)}${unit === "degrees" ? "°" : ` ${unit}`}`.trim();
    }
  }

  #text(name: Shown): string {
    return String(this.#element[name === "wind-direction" ? "windDirection" : name]);
  }
}

function select(choices: readonly string[]): HTMLSelectElement {
  const select = document.createElement("select");
  for (const choice of choices) select.add(new Option(choice, choice));
  return select;
}

function numberInput({ min, max, integer }: NumberSetting, sliderStep: number): HTMLInputElement {
  const input = document.createElement("input");
  input.type = integer ? "number" : "range";
  input.min = String(min);
  input.max = String(max);
  input.step = String(integer ? 1 : sliderStep);
  return input;
}
