import type { CandleFlameElement } from "../candle-flame-element.js";

/** Index of A among the buttons of the W3C's standard gamepad. */
const A = 0;

/**
 * Lets a gamepad's A walk in where the page has the focus, or the button that walks in: the room itself minds gamepads
 * only while the focus is its own.
 *
 * @param enter button that walks in, disabled while there is no room
 */
export function followGamepads(room: CandleFlameElement, enter: HTMLButtonElement): void {
  let wasDown = false;
  let request = 0;
  const poll = () => {
    const pads = connectedGamepads();
    const isDown = pads.some((pad) => pad.buttons[A]?.pressed);
    const isHere = document.hasFocus() && [document.body, enter].some(isFocused);
    if (isDown && !wasDown && isHere && !enter.disabled) room.enter();
    wasDown = isDown;
    request = pads.length > 0 ? requestAnimationFrame(poll) : 0;
  };
  // With the first button that is pressed.
  addEventListener("gamepadconnected", () => {
    if (request === 0) poll();
  });
}

function isFocused(element: Element): boolean {
  return document.activeElement === element;
}

function connectedGamepads(): Gamepad[] {
  try {
    return navigator.getGamepads().filter((pad) => pad?.mapping === "standard") as Gamepad[];
  } catch {
    return []; // a frame whose permissions policy forbids them
  }
}
