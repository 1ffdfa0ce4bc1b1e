import type { ChoiceSetting, FlagSetting, NumberSetting, TextSetting } from "../settings.js";

export type Setting = NumberSetting | ChoiceSetting | FlagSetting | TextSetting;
export type Control = HTMLInputElement | HTMLSelectElement;

/** A setting's row of a form: label, control and meaning. */
export function settingRow(
  control: Control,
  { id, name, meaning }: { readonly id: string; readonly name: string; readonly meaning: string },
) {
  control.id = id;
  const row = document.createElement("div");
  const label = document.createElement("label");
  label.htmlFor = id;
  label.textContent = name;
  const sentence = document.createElement("p");
  sentence.id = `${id}-meaning`;
  sentence.textContent = meaning;
  control.setAttribute("aria-describedby", sentence.id);
  row.append(label, control, sentence);
  return row;
}

/**
 * A control for a setting, at its default.
 *
 * @param step of numbers that need not be whole
 */
export function controlOf(setting: Setting, step: number | "any"): Control {
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
