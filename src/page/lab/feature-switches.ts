import type { CandleFlameElement, Feature } from "../../candle-flame-element.js";
import { FEATURES } from "../../settings.js";

/** A checkbox for each technique, with its sentence. */
export class FeatureSwitches {
  readonly #element: CandleFlameElement;
  readonly #boxes = new Map<Feature, HTMLInputElement>();

  constructor(element: CandleFlameElement, list: HTMLElement) {
    this.#element = element;
    for (const [name, sentence] of Object.entries(FEATURES) as [Feature, string][]) {
      const box = document.createElement("input");
      box.type = "checkbox";
      box.name = name;
      box.addEventListener("change", () => {
        element.features[name] = box.checked;
      });
      this.#boxes.set(name, box);
      const label = document.createElement("label");
      const meaning = document.createElement("span");
      meaning.textContent = sentence;
      label.append(box, name, meaning);
      list.append(label);
    }
    this.refresh();
  }

  refresh(): void {
    for (const [name, box] of this.#boxes) box.checked = this.#element.features[name];
  }
}
