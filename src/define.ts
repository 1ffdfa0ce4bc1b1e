import { CandleFlameElement } from "./candle-flame-element.js";

if (globalThis.customElements && !customElements.get("candle-flame")) {
  customElements.define("candle-flame", CandleFlameElement);
}
