import type { CandleFlameElement, Look } from "../../candle-flame-element.js";
import { parseChoice, SETTINGS } from "../../settings.js";
import { find } from "../find.js";
import type { Comparison } from "./comparison.js";
import { Divider } from "./divider.js";

/** Table 2, live: which two looks, and the button that opens and closes the comparison. */
export class ComparisonSection {
  readonly #room: CandleFlameElement;
  readonly #comparison: Comparison;
  readonly #divider: Divider;
  readonly #left: HTMLSelectElement;
  readonly #right: HTMLSelectElement;
  readonly #button: HTMLButtonElement;
  readonly #status: HTMLElement;

  constructor(
    section: HTMLElement,
    divider: HTMLElement,
    room: CandleFlameElement,
    stage: HTMLElement,
    comparison: Comparison,
  ) {
    this.#room = room;
    this.#comparison = comparison;
    this.#divider = new Divider(divider, stage, () => {
      comparison.close();
      this.#button.focus();
    });
    this.#left = find(section, "[name=left]", HTMLSelectElement);
    this.#right = find(section, "[name=right]", HTMLSelectElement);
    this.#button = find(section, ".compare", HTMLButtonElement);
    this.#status = find(section, ".status", HTMLElement);
    for (const look of SETTINGS.look.choices) {
      this.#left.add(new Option(look, look));
      this.#right.add(new Option(look, look));
    }
    this.#left.value = room.look;
    this.#left.addEventListener("change", () => {
      comparison.look = this.#leftLook;
      this.refresh();
    });
    // The visitor's own room is the one on the right.
    this.#right.addEventListener("change", () => {
      room.look = parseChoice(SETTINGS.look, this.#right.value);
    });
    find(section, "form", HTMLFormElement).addEventListener("submit", (event) => {
      event.preventDefault();
      if (comparison.state === "closed") comparison.open(this.#leftLook);
      else comparison.close();
    });
    comparison.onChange = (failure) => this.#show(failure);
    this.refresh();
  }

  get #leftLook(): Look {
    return parseChoice(SETTINGS.look, this.#left.value);
  }

  set isDisabled(isDisabled: boolean) {
    for (const control of [this.#left, this.#right, this.#button]) control.disabled = isDisabled;
  }

  refresh(): void {
    this.#show("");
  }

  #show(failure: string): void {
    const { state } = this.#comparison;
    const isClosed = state === "closed";
    const { look } = this.#room;
    this.#right.value = look;
    // A look beside itself is no comparison.
    if (isClosed && this.#left.value === look) {
      this.#left.value = SETTINGS.look.choices.findLast((other) => other !== look) ?? look;
    }
    this.#button.setAttribute("aria-pressed", String(!isClosed));
    this.#button.textContent = isClosed ? "Compare" : "Stop comparing";
    this.#status.textContent = state === "loading" ? "Building the second room." : failure;
    if (state === "open") this.#divider.show([this.#leftLook, this.#room.look]);
    else this.#divider.hide();
  }
}
