import type { CandleFlameElement } from "../../candle-flame-element.js";
import "../../define.js";
import { find } from "../find.js";
import { followAttributes } from "../follow-attributes.js";
import { showValue } from "../show-value.js";
import { addCopyButton } from "./copy-button.js";
import { bindLiveFigure } from "./live-figure.js";
import { addTryOut } from "./try-out.js";

document.querySelectorAll<HTMLElement>("figure.live").forEach(bindLiveFigure);
document.querySelectorAll<HTMLElement>(".snippet").forEach(addCopyButton);

const tried = find(document, "#tried", HTMLElement) as CandleFlameElement;
const glowing = find(document, ".glowing", HTMLElement);
addTryOut(
  tried,
  find(document, ".attributes", HTMLFormElement),
  find(document, "#tried-snippet code", HTMLElement),
);

const log = find(document, ".events", HTMLElement);
const EVENTS = ["load", "error", "play", "pause", "light", "extinguish", "place", "take"] as const;
/** Before the event: time also stops while the candle is out of sight, which is not logged. */
let isPaused = false;
// Out of sight there is no event: time stands already.
followAttributes(tried, ["paused"], () => {
  isPaused = tried.paused;
});
for (const type of EVENTS) {
  tried.addEventListener(type, () => {
    if (type === "pause" || type === "play") {
      if (tried.paused === isPaused) return;
      isPaused = tried.paused;
    }
    log.textContent = `event: ${type}`;
  });
}

const scripted = find(document, "#scripted candle-flame", HTMLElement) as CandleFlameElement;
const state = find(document, "#scripted output", HTMLOutputElement);
for (const type of ["light", "extinguish"] as const) {
  scripted.addEventListener(type, () => {
    state.value = scripted.lit ? "lit" : "out";
  });
}

const slider = find(document, ".glow", HTMLInputElement);
const output = find(document, ".glow ~ output", HTMLOutputElement);
const shine = () => {
  glowing.style.setProperty("--candle-flame-glow", slider.value);
  showValue(slider, output, slider.value);
};
slider.addEventListener("input", shine);
shine();
