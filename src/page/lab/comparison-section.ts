import type { CandleFlameElement } from "../../candle-flame-element.js";
import { parseChoice, SETTINGS } from "../../settings.js";
import { find } from "../find.js";
import { followAttributes } from "../follow-attributes.js";
import type { Comparison } from "./comparison.js";
import { bindDivider } from "./divider.js";

/**
 * Binds Table 2, live: the choice of two looks, and the button that opens and closes the comparison.
 *
 * @param opener button that opens the lab
 * @returns what disables them, or enables them
 */
export function bindComparison(
  section: HTMLElement,
  line: HTMLElement,
  room: CandleFlameElement,
  stage: HTMLElement,
  comparison: Comparison,
  opener: HTMLElement,
): (isDisabled: boolean) => void {
  const left = find(section, "[name=left]", HTMLSelectElement);
  const right = find(section, "[name=right]", HTMLSelectElement);
  const button = find(section, ".compare", HTMLButtonElement);
  const status = find(section, ".status", HTMLElement);
  const divider = bindDivider(line, stage, () => {
    comparison.close();
    button.focus();
    // With the lab closed, its button cannot have the focus.
    if (document.activeElement !== button) opener.focus();
  });
  const lookOf = ({ value }: HTMLSelectElement) => parseChoice(SETTINGS.look, value);

  function show(failure: string): void {
    const { state } = comparison;
    const isClosed = state === "closed";
    const { look } = room;
    right.value = look;
    // A look beside itself is no comparison.
    if (isClosed && left.value === look) {
      left.value = SETTINGS.look.choices.findLast((other) => other !== look) ?? look;
    }
    button.textContent = isClosed ? "Compare" : "Stop comparing";
    status.textContent = state === "loading" ? "Building the second room." : failure;
    if (state === "open") divider.show([lookOf(left), look]);
    else divider.clear();
  }

  for (const list of [left, right]) {
    for (const look of SETTINGS.look.choices) list.add(new Option(look, look));
  }
  left.value = room.look;
  left.addEventListener("change", () => {
    comparison.look = lookOf(left);
    show("");
  });
  // The visitor's own room is the one on the right.
  right.addEventListener("change", () => {
    room.look = lookOf(right);
  });
  find(section, "form", HTMLFormElement).addEventListener("submit", (event) => {
    event.preventDefault();
    if (comparison.state === "closed") comparison.open(lookOf(left));
    else comparison.close();
  });
  comparison.onChange = show;
  // The look goes back after a failure, of which the sentence stays.
  followAttributes(room, ["look"], () =>
    show(comparison.state === "closed" ? (status.textContent ?? "") : ""),
  );
  return (isDisabled) => {
    for (const control of [left, right, button]) control.disabled = isDisabled;
  };
}
