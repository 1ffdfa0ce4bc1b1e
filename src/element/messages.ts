import type { Refusal } from "../world/room/placement.js";
import type { CandleDetail } from "./events.js";

export const NO_PHYSICAL_LOOK =
  "This driver cannot render to floats: the room has the paper's look.";

export const LOST = "The graphics driver was lost, and the browser has not restored it.";

export const FULL =
  "This page has as many rooms open as a browser can show. This one opens once there is a place.";

/** Why the candle could not be put down, or taken up. */
export const REFUSALS: Readonly<Record<Refusal, string>> = {
  "nothing within reach": "The candle cannot stand there: nothing is within reach.",
  "too steep": "The candle cannot stand there: it is too steep.",
  overhangs: "The candle cannot stand there: it would hang over the edge.",
  "no room": "The candle cannot stand there: there is no room for it.",
  "out of reach": "The candle cannot be taken up: it is out of reach.",
};

/** @param lighting what the visitor does to light it; null if there is nothing */
export function outSentence(lighting: string | null): string {
  return `The candle is out.${lighting ? ` ${lighting} to light it.` : ""}`;
}

export function changeSentence(candle: CandleDetail, isLit: boolean): string {
  return `${upperFirst(spokenName(candle, ","))} ${isLit ? "burns" : "is out"}.`;
}

export function reachedSentence(candle: CandleDetail, lighting: string): string {
  return `${lighting} to light ${spokenName(candle)}.`;
}

/** Name of a candle in a sentence: its number, and the words of its wick's name: `wick-mantel-left`. */
function spokenName({ index, name }: CandleDetail, end = ""): string {
  const words = name
    .replace(/^wick/, "")
    .replace(/[^\p{L}]+/gu, " ")
    .trim();
  return `candle ${index + 1}${words ? `, ${words}${end}` : ""}`;
}

const upperFirst = (text: string) => text.charAt(0).toUpperCase() + text.slice(1);
