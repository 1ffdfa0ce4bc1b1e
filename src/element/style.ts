/**
 * The poster that is hidden fades over a complete canvas. Where nothing is rendered, or a browser knows no discrete
 * transition, it is gone at once.
 *
 * A popover is hidden until it is open, and then lies where browsers put any. Browsers without popovers drop these rules,
 * which are apart from the others for that reason.
 *
 * What is before the content gives an intrinsic width.
 *
 * The ring of the focus lies on a dark one, which is seen on light pages.
 *
 * Scaled to nothing, the hint is there for screen readers alone, and makes no page wider; what lasts is shown.
 *
 * The hint's animation begins after a delay, which is no part of it: while one runs, software compositors draw the page
 * 60 times a second.
 */
const STYLE = `
:host {
  display: block;
  position: relative;
  aspect-ratio: 16 / 9;
  inline-size: 100%;
  box-sizing: border-box;
  overflow: hidden;
  background: #050302;
  color: #f3e7d3;
  font: 1rem/1.5 system-ui, sans-serif;
}
:host::before { content: ""; display: grid; grid: auto / minmax(0, 300px); }
:host(:is(:state(alone), [state-alone])) { overflow: visible; background: none; color: inherit; isolation: isolate; }
[part="glow"] { display: none; }
:host(:is(:state(alone), [state-alone])) [part="glow"] {
  display: block;
  position: absolute;
  z-index: -1;
  inset: 30% auto auto 50%;
  inline-size: 1px;
  block-size: 1px;
  border-radius: 50%;
  pointer-events: none;
  opacity: calc(clamp(0, var(--candle-flame-glow, 0), 1) * var(--intensity, 0));
  box-shadow: 0 0 120px 60px #ffb05480, 0 0 320px 160px #ff963c59;
}
:host([hidden]) { display: none; }
:host([popover]:not(:popover-open)) { display: none; }
:host(:popover-open) { position: fixed; }
:host(:focus-visible), [part="reload"]:focus-visible { outline: 2px solid #f3c98b; outline-offset: 2px; box-shadow: 0 0 0 8px #050302; }
canvas, [part="poster"], ::slotted([slot="poster"]) {
  position: absolute;
  inset: 0;
  inline-size: 100%;
  block-size: 100%;
  writing-mode: horizontal-tb;
}
[part="poster"], ::slotted([slot="poster"]) { object-fit: cover; }
slot[name="poster"] {
  display: block;
  position: absolute;
  inset: 0;
}
slot[name="poster"][hidden] {
  opacity: 0;
  pointer-events: none;
}
:host(:is(:state(loading), [state-loading])) canvas { visibility: hidden; }
:host(:is(:state(walking), [state-walking])) canvas {
  touch-action: none;
  user-select: none;
  -webkit-user-select: none;
  -webkit-touch-callout: none;
}
:host([controls]:is(:state(alone), [state-alone])) canvas { touch-action: manipulation; }
[hidden] { display: none !important; }
[part="progress"] {
  position: absolute;
  inset-inline-start: 0;
  inset-block-end: 0;
  block-size: var(--candle-flame-progress-height, 3px);
  background: var(--candle-flame-progress-color, #f0a54a);
}
[part="hint"] {
  display: grid;
  position: absolute;
  inset-inline: 1rem;
  inset-block-end: calc(1.5rem + env(safe-area-inset-bottom));
  pointer-events: none;
  text-align: center;
  text-wrap: balance;
}
p, [part="reload"] {
  margin: 0;
  padding: 0.5rem 1rem;
  border-radius: 2px;
  background: #0b0705cc;
  color: #f3e7d3;
}
[part="hint"] p {
  justify-self: center;
  font-size: 0.9375rem;
  animation: hint 0.5s ease-in 4.5s forwards;
}
[part="hint"] .controls, ::slotted([slot="hint"]) { animation: hint 0.5s ease-in 7.5s forwards; }
[part="hint"] .lasting { animation-delay: 19.5s; }
:host(:not([controls])) [part="hint"] p:not(.lasting) { scale: 0; animation: none; }
kbd {
  display: inline-block;
  min-inline-size: 1.7em;
  margin-inline: 0.1em;
  padding-inline: 0.4em;
  border: 1px solid #f3e7d340;
  border-radius: 2px;
  font: 0.8em/1.6 system-ui, sans-serif;
}
@media (prefers-reduced-motion: no-preference) {
  slot[name="poster"][hidden] { transition: opacity 0.4s ease-out, display 0.4s allow-discrete; }
  [part="progress"].full { animation: wait 1.6s ease-in-out infinite alternate; }
}
@keyframes wait {
  from { transform: translateX(-40%) scaleX(0.2); }
  to { transform: translateX(40%) scaleX(0.2); }
}
@keyframes hint {
  99% { scale: 1 }
  to { opacity: 0; scale: 0 }
}
@media (prefers-contrast: more) {
  p { background: #000; color: #fff; outline: 1px solid; }
  :host(:focus-visible) { outline-width: 4px; outline-color: #fff; }
}
@media (forced-colors: active) {
  p { background: Canvas; outline: 1px solid; }
  [part="progress"] { background: Highlight; }
}
[part="error"] {
  position: absolute;
  inset: 0;
  display: grid;
  place-content: center;
  place-content: safe center;
  justify-items: center;
  gap: 0.5rem;
  padding: 0.5rem;
  overflow: auto;
  text-align: center;
  text-wrap: balance;
}
[part="error"] p { max-inline-size: 40ch; }
[part="reload"] {
  border: 1px solid #f3c98b;
  font: inherit;
  cursor: pointer;
}
[part="reload"]:hover { background: #2a1c10; }
`;

const sheets = new WeakMap<Document, CSSStyleSheet>();

/**
 * The style for shadow trees in a document, constructed, so that a strict CSP allows it; none for a document
 * without a window.
 */
export function styleFor(document: Document): CSSStyleSheet[] {
  const cached = sheets.get(document);
  if (cached) return [cached];
  if (!document.defaultView) return [];
  // A document accepts only style sheets of its own window.
  const sheet = new document.defaultView.CSSStyleSheet();
  sheet.replaceSync(STYLE);
  sheets.set(document, sheet);
  return [sheet];
}
