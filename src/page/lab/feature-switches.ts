import type { CandleFlameElement, Feature } from "../../candle-flame-element.js";
import { FEATURES, FEATURES_OF } from "../../settings.js";
import { FEATURE_MEANINGS } from "../meanings.js";

/** A checkbox for each technique of the current look, with its meaning. */
export class FeatureSwitches {
  readonly #element: CandleFlameElement;
  readonly #list: HTMLElement;
  readonly #rows = new Map<Feature, { label: HTMLElement; box: HTMLInputElement }>();

  constructor(element: CandleFlameElement, list: HTMLElement) {
    this.#element = element;
    this.#list = list;
    for (const name of FEATURES) {
      const box = document.createElement("input");
      box.type = "checkbox";
      box.name = name;
      box.addEventListener("change", () => {
        element.features[name] = box.checked;
      });
      const label = document.createElement("label");
      const meaning = document.createElement("span");
      meaning.textContent = FEATURE_MEANINGS[name];
      label.append(box, name, meaning);
      this.#rows.set(name, { label, box });
    }
    this.refresh();
  }

  refresh(): void {
    const { features, look } = this.#element;
    for (const [name, { box }] of this.#rows) box.checked = features[name];
    const labels = FEATURES_OF[look].flatMap((name) => this.#rows.get(name)?.label ?? []);
    const isSame = labels.every((label, i) => label === this.#list.children[i]);
    // What stays keeps the focus.
    if (!isSame || labels.length !== this.#list.childElementCount) {
      this.#list.replaceChildren(...labels);
    }
  }
}
