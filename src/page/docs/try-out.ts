import type { CandleFlameElement } from "../../candle-flame-element.js";
import {
  type ChoiceSetting,
  type FlagSetting,
  type NumberSetting,
  SETTINGS,
  type SettingName,
  type TextSetting,
} from "../../settings.js";
import { SETTING_MEANINGS } from "../meanings.js";
import { tagOf } from "./snippet.js";

type Setting = NumberSetting | ChoiceSetting | FlagSetting | TextSetting;
type Control = HTMLInputElement | HTMLSelectElement;

/** A control for every attribute that there is, made from the table of settings. */
export class TryOut {
  readonly #element: CandleFlameElement;
  readonly #code: HTMLElement;
  readonly #assetBase: string;
  readonly #controls = new Map<SettingName, Control>();

  constructor(element: CandleFlameElement, form: HTMLFormElement, code: HTMLElement) {
    this.#element = element;
    this.#code = code;
    this.#assetBase = element.assetBase;
    form.addEventListener("submit", (event) => event.preventDefault());
    for (const name of Object.keys(SETTINGS) as SettingName[]) form.append(this.#row(name));
    this.#show();
    // Methods change attributes too.
    new MutationObserver(() => this.#show()).observe(element, { attributes: true });
  }

  #row(name: SettingName): HTMLElement {
    const setting: Setting = SETTINGS[name];
    const row = document.createElement("div");
    const label = document.createElement("label");
    const control = controlOf(setting);
    control.id = `try-${name}`;
    control.name = name;
    label.htmlFor = control.id;
    label.textContent = name;
    const meaning = document.createElement("p");
    meaning.id = `${control.id}-meaning`;
    meaning.textContent = `${SETTING_MEANINGS[name]}${rangeOf(setting)}`;
    control.setAttribute("aria-describedby", meaning.id);
    control.addEventListener("change", () => {
      if (isCheckbox(control)) this.#element.toggleAttribute(name, control.checked);
      else this.#element.setAttribute(name, control.value);
    });
    this.#controls.set(name, control);
    row.append(label, control, meaning);
    return row;
  }

  #show(): void {
    const attributes: Partial<Record<SettingName, string>> = {};
    for (const [name, control] of this.#controls) {
      const text = this.#element.getAttribute(name);
      if (isCheckbox(control)) control.checked = text !== null;
      else if (text !== null) control.value = text;
      // Where this page has its models is no concern of others.
      const isOurs = name === "asset-base" && text === this.#assetBase;
      if (text !== null && !isOurs) attributes[name] = text;
    }
    this.#code.textContent = tagOf(attributes);
  }
}

function isCheckbox(control: Control): control is HTMLInputElement {
  return control.type === "checkbox";
}

function controlOf(setting: Setting): Control {
  if (setting.kind === "choice") {
    const select = document.createElement("select");
    for (const choice of setting.choices) select.add(new Option(choice, choice));
    return select;
  }
  const input = document.createElement("input");
  if (setting.kind === "flag") {
    input.type = "checkbox";
  } else if (setting.kind === "number") {
    input.type = "number";
    input.min = String(setting.min);
    input.max = String(setting.max);
    input.step = setting.integer ? "1" : "any";
    input.value = String(setting.default);
  } else {
    input.type = "text";
    input.value = setting.default;
  }
  return input;
}

function rangeOf(setting: Setting): string {
  if (setting.kind !== "number") return "";
  const { min, max, unit } = setting;
  return ` ${min} to ${max}${unit === "" ? "" : ` ${unit}`}.`;
}
