import type { CandleFlameElement } from "../../candle-flame-element.js";
import { SETTING_NAMES, SETTINGS, type Setting, type SettingName } from "../../settings.js";
import { followAttributes } from "../follow-attributes.js";
import { SETTING_MEANINGS } from "../meanings.js";
import { addRow, type Control } from "../settings-form.js";
import { tagOf } from "./snippet.js";

/** Adds a control for every attribute to a form, made from the table of settings; the code shows their markup. */
export function addTryOut(
  element: CandleFlameElement,
  form: HTMLFormElement,
  code: HTMLElement,
): void {
  const { assetBase } = element;
  const controls = SETTING_NAMES.map((name) => [name, addControl(element, form, name)] as const);
  form.addEventListener("submit", (event) => event.preventDefault());
  followAttributes(element, SETTING_NAMES, () => {
    const attributes: Partial<Record<SettingName, string>> = {};
    for (const [name, control] of controls) {
      const text = element.getAttribute(name);
      if (isCheckbox(control)) control.checked = text !== null;
      else if (text !== null) control.value = text;
      // The folder of this page's own models is left out of the snippet.
      const isOurs = name === "asset-base" && text === assetBase;
      if (text !== null && !isOurs) attributes[name] = text;
    }
    code.textContent = tagOf(attributes);
  });
}

function addControl(element: CandleFlameElement, form: HTMLElement, name: SettingName): Control {
  const meaning = `${SETTING_MEANINGS[name]}${rangeOf(SETTINGS[name])}`;
  const control = addRow(form, name, name, meaning, "any");
  const { kind } = SETTINGS[name];
  control.name = name;
  control.addEventListener("change", () => {
    if (isCheckbox(control)) element.toggleAttribute(name, control.checked);
    else if (kind === "number" && control.value === "") element.removeAttribute(name);
    else element.setAttribute(name, control.value);
  });
  return control;
}

function isCheckbox(control: Control): control is HTMLInputElement {
  return control.type === "checkbox";
}

function rangeOf(setting: Setting): string {
  if (setting.kind !== "number") return "";
  const { min, max, unit } = setting;
  return ` ${min} to ${max}${unit === "" ? "" : ` ${unit}`}.`;
}
