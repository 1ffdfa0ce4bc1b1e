/** Styles of the element's shadow tree; constructed, so that a strict CSP allows them. */
export const STYLE = `
:host {
  display: block;
  position: relative;
  aspect-ratio: 16 / 9;
  inline-size: 100%;
  overflow: hidden;
  background: #050302;
  color: #f3e7d3;
  font: 1rem/1.5 system-ui, sans-serif;
}
:host([hidden]) { display: none; }
:host(:focus-visible) { outline: 2px solid #f3c98b; outline-offset: 2px; }
canvas, [part="poster"] {
  position: absolute;
  inset: 0;
  inline-size: 100%;
  block-size: 100%;
}
[part="poster"] { object-fit: cover; }
:host(:state(loading)) canvas { visibility: hidden; }
:host(:state(walking)) canvas { touch-action: none; }
[hidden] { display: none !important; }
[part="progress"] {
  position: absolute;
  inset-inline: 0;
  inset-block-end: 0;
  block-size: var(--candle-flame-progress-height, 3px);
  background: var(--candle-flame-progress-color, #f0a54a);
  transform-origin: left;
}
[part="hint"] {
  position: absolute;
  inset-inline: 0;
  inset-block-end: 12%;
  pointer-events: none;
  text-align: center;
}
[part="hint"] p {
  display: inline-block;
  margin: 0;
  padding: 0.4rem 0.9rem;
  border-radius: 0.5rem;
  background: #140d08d9;
  animation: hint 4s ease-in forwards;
}
@keyframes hint { 0%, 75% { opacity: 1 } 100% { opacity: 0 } }
[part="error"] {
  position: absolute;
  inset: 0;
  display: grid;
  place-content: center;
  padding: 1.5rem;
  text-align: center;
  text-wrap: balance;
}
[part="error"] p { margin: 0; max-inline-size: 40ch; padding: 0.75rem 1rem; background: #140d08d9; border-radius: 0.5rem; }
`;
