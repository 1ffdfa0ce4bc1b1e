import type { CandleFlameElement } from "../candle-flame-element.js";

/** In `:is()`, since outside of it an unknown `:state()` invalidates the whole selector. */
const WALKING = ":is(:state(walking), [state-walking])";
const CHANGES = ["enter", "leave", "load", "error"] as const;

export function isWalking(room: Element): boolean {
  return room.matches(WALKING);
}

/**
 * Reflects it as the body's class `walking`, and as `touched` that a finger was the last pointer: of a machine with
 * a mouse and a touch screen, media queries know only what is there. (`:has()` is newer than the oldest browsers.)
 */
export function reflectWalking(room: CandleFlameElement): void {
  const notePointer = ({ pointerType }: PointerEvent) =>
    document.body.classList.toggle("touched", pointerType === "touch");
  addEventListener("pointerdown", notePointer, { capture: true });
  const reflect = () => document.body.classList.toggle("walking", isWalking(room));
  for (const type of CHANGES) room.addEventListener(type, reflect);
}
