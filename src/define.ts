import { CandleFlameElement } from "./candle-flame-element.js";

/** On a server there is no DOM, and in the DOM of unit tests (jsdom, happy-dom) not all that the element stands on. */
const isSupported =
  globalThis.customElements &&
  (!globalThis.HTMLElement ||
    ["attachInternals", "part"].every((name) => name in HTMLElement.prototype));

if (isSupported && !customElements.get("candle-flame")) {
  customElements.define("candle-flame", CandleFlameElement);
}
