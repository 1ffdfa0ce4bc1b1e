import type { CandleFlameElement, Look } from "../../candle-flame-element.js";
import { SETTING_NAMES, type SettingName } from "../../settings.js";

/** Attributes that the two rooms do not share. */
const OWN: readonly SettingName[] = ["look", "controls", "paused", "alt"];
export const SHARED = SETTING_NAMES.filter((name) => !OWN.includes(name));

/** The same room once more, in a look, paused and not inserted yet; screen readers have the first. */
export function createSecondRoom(room: CandleFlameElement, look: Look): CandleFlameElement {
  const second = document.createElement("candle-flame");
  copyShared(room, second);
  second.look = look;
  second.paused = true;
  second.className = "second";
  second.setAttribute("aria-hidden", "true");
  return second;
}

export function copyShared(from: CandleFlameElement, to: CandleFlameElement): void {
  for (const name of SHARED) {
    const value = from.getAttribute(name);
    if (value === to.getAttribute(name)) continue;
    if (value === null) to.removeAttribute(name);
    else to.setAttribute(name, value);
  }
}
