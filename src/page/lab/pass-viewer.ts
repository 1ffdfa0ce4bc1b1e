import type { CandleFlameElement, Inspection } from "../../candle-flame-element.js";
import { INSPECTIONS } from "../../settings.js";
import { drawnLook } from "../drawn-look.js";
import { find } from "../find.js";
import { followAttributes } from "../follow-attributes.js";
import { INSPECTION_MEANINGS } from "../meanings.js";

/**
 * Pass viewer: binds a list by whose choice the output of a pass is shown instead of the frame.
 *
 * @returns what displays the frame again
 */
export function bindPassViewer(section: HTMLElement, room: CandleFlameElement): () => void {
  const list = find(section, "select", HTMLSelectElement);
  const sentence = find(section, ".status", HTMLElement);
  for (const name of INSPECTIONS) list.add(new Option(name.replace("-", " "), name));
  const refresh = () => {
    const { inspect } = room;
    const hasPasses = drawnLook(room) === "physical";
    list.value = inspect;
    list.disabled = !hasPasses;
    sentence.textContent = hasPasses
      ? INSPECTION_MEANINGS[inspect]
      : "The paper's looks are drawn at once: they have no passes to look at.";
  };
  const show = (inspection: Inspection) => {
    room.inspect = inspection;
    refresh();
  };
  list.addEventListener("change", () => show(list.value as Inspection));
  followAttributes(room, ["look"], refresh);
  room.addEventListener("load", refresh);
  return () => show("picture");
}
