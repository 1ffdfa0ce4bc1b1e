import type { CandleFlameElement } from "../../candle-flame-element.js";
import { FEATURES, featuresOf } from "../../settings.js";
import { drawnLook } from "../drawn-look.js";
import { followAttributes } from "../follow-attributes.js";
import { FEATURE_MEANINGS } from "../meanings.js";

/** Fills a list with a checkbox for each technique of the current look, and its meaning. */
export function addFeatureSwitches(element: CandleFlameElement, list: HTMLElement): void {
  const rows = FEATURES.map((name) => {
    const box = document.createElement("input");
    box.type = "checkbox";
    box.name = name;
    box.addEventListener("change", () => {
      element.features[name] = box.checked;
    });
    const meaning = document.createElement("span");
    meaning.textContent = FEATURE_MEANINGS[name];
    const label = document.createElement("label");
    label.append(box, name, meaning);
    return { name, box, label };
  });
  const refresh = () => {
    const { features } = element;
    for (const { name, box } of rows) box.checked = features[name];
    const labels = featuresOf(drawnLook(element)).flatMap(
      (name) => rows.find((row) => row.name === name)?.label ?? [],
    );
    // Labels that stay keep the focus.
    const isSame = labels.every((label, i) => label === list.children[i]);
    if (!isSame || labels.length !== list.childElementCount) list.replaceChildren(...labels);
  };
  followAttributes(element, ["look"], refresh);
  element.addEventListener("load", refresh);
}
