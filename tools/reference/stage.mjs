/**
 * Brings an element to a view of `views.json`: the page runs it, so that it uses nothing from outside.
 *
 * The carried candle is put down from `place`. `wicks` names further candles that burn, `unlit` leaves the carried one out,
 * and there is a moon only where the view has one.
 *
 * @param {import("../../src/candle-flame-element.js").CandleFlameElement} element
 * @param {{
 *   readonly place?: import("../../src/candle-flame-element.js").Camera,
 *   readonly camera?: import("../../src/candle-flame-element.js").Camera,
 *   readonly wicks?: readonly string[],
 *   readonly unlit?: boolean,
 *   readonly moon?: { readonly illuminance: number },
 * }} view
 */
export function stageView(element, { place, camera, wicks = [], unlit = false, moon }) {
  element.unlit = unlit;
  element.reset();
  element.setAttribute("moonlight", String(moon?.illuminance ?? 0));
  if (place) {
    element.camera = place;
    element.place();
  }
  if (camera) element.camera = camera;
  for (const candle of element.candles.slice(1)) candle.lit = wicks.includes(candle.name);
  // Until a new flame has grown.
  element.step(wicks.length > 0 ? 2 : 0);
}
