import type { CandleFlameElement, Inspection } from "../../candle-flame-element.js";
import { INSPECTIONS } from "../../settings.js";
import { find } from "../find.js";
import { INSPECTION_MEANINGS } from "../meanings.js";

/** Pass viewer: shows the output of a pass instead of the frame. */
export class PassViewer {
  readonly #room: CandleFlameElement;
  readonly #list: HTMLSelectElement;
  readonly #sentence: HTMLElement;

  constructor(section: HTMLElement, room: CandleFlameElement) {
    this.#room = room;
    this.#list = find(section, "select", HTMLSelectElement);
    this.#sentence = find(section, ".status", HTMLElement);
    for (const name of INSPECTIONS) {
      this.#list.add(new Option(name.replace("-", " "), name));
    }
    this.#list.addEventListener("change", () => {
      room.inspect = this.#list.value as Inspection;
      this.refresh();
    });
    this.refresh();
  }

  /** Back to the frame itself, so that no visitor is left with a depth buffer. */
  close(): void {
    this.#room.inspect = "picture";
    this.refresh();
  }

  refresh(): void {
    const { inspect, look } = this.#room;
    const hasPasses = look === "physical";
    this.#list.value = inspect;
    this.#list.disabled = !hasPasses;
    this.#sentence.textContent = hasPasses
      ? INSPECTION_MEANINGS[inspect]
      : "The paper's looks are drawn at once: they have no passes to look at.";
  }
}
