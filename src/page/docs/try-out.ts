import type { CandleFlameElement } from "../../candle-flame-element.js";
import { SETTINGS, type SettingName } from "../../settings.js";
import { SETTING_MEANINGS } from "../meanings.js";
import { type Control, controlOf, type Setting, settingRow } from "../setting-row.js";
import { tagOf } from "./snippet.js";

/** A control for every attribute, made from the table of settings. */
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
    const control = controlOf(setting, "any");
    control.name = name;
    control.addEventListener("change", () => {
      if (isCheckbox(control)) this.#element.toggleAttribute(name, control.checked);
      else this.#element.setAttribute(name, control.value);
    });
    this.#controls.set(name, control);
    const meaning = `${SETTING_MEANINGS[name]}${rangeOf(setting)}`;
    return settingRow(control, { id: `try-${name}`, name, meaning });
  }

  #show(): void {
    const attributes: Partial<Record<SettingName, string>> = {};
    for (const [name, control] of this.#controls) {
      const text = this.#element.getAttribute(name);
      if (isCheckbox(control)) control.checked = text !== null;
      else if (text !== null) control.value = text;
      // The folder of this page's own models is left out of the snippet.
      const isOurs = name === "asset-base" && text === this.#assetBase;
      if (text !== null && !isOurs) attributes[name] = text;
    }
    this.#code.textContent = tagOf(attributes);
  }
}

function isCheckbox(control: Control): control is HTMLInputElement {
  return control.type === "checkbox";
}

function rangeOf(setting: Setting): string {
  if (setting.kind !== "number") return "";
  const { min, max, unit } = setting;
  return ` ${min} to ${max}${unit === "" ? "" : ` ${unit}`}.`;
}
