import { type Action, type Intent, STILL } from "../world/player/intent.js";
import { beyondDeadZone } from "./gamepads.js";

/** Distance of a thumb for walking pace, CSS pixels; farther is running. */
const REACH = 60;
const RUN_REACH = 105;
/** Radians turned per CSS pixel of a finger: half a turn across a phone held upright. */
const SENSITIVITY = 0.006;
/** Distance up to which a finger counts as still, CSS pixels. */
const STEADY = 12;
/** Longest tap, longest time between two of them, and shortest hold, milliseconds. */
const TAP = 250;
const DOUBLE_TAP = 350;
const HOLD = 550;
/** Largest distance between the taps of a double tap, CSS pixels. */
const SAME_PLACE = 48;

interface Finger {
  readonly walks: boolean;
  readonly begin: PointerEvent;
  last: PointerEvent;
  isSteady: boolean;
}

/**
 * Fingers as an intent.
 *
 * A finger put down in the left half is a stick that walks, with its middle where it touched; in the
 * right half it drags the view. Two quick taps are for the flame; a finger held still on the right puts
 * the candle down or takes it up.
 */
export class Touch {
  readonly #window: Window;
  readonly #fingers = new Map<number, Finger>();
  #lastTap: PointerEvent | null = null;
  #yaw = 0;
  #pitch = 0;
  #actions: Partial<Record<Action, true>> = {};
  #holdTimer = 0;

  /** @param view that shows what is touched */
  constructor(view: Window) {
    this.#window = view;
  }

  /** @param box where the zones are, in client coordinates */
  down(begin: PointerEvent, box: DOMRect): void {
    const { pointerId } = begin;
    const walks = begin.clientX < box.left + box.width / 2;
    const finger: Finger = { walks, begin, last: begin, isSteady: true };
    this.#fingers.set(pointerId, finger);
    if (walks) return;
    this.#window.clearTimeout(this.#holdTimer);
    this.#holdTimer = this.#window.setTimeout(() => {
      if (finger.isSteady && this.#fingers.get(pointerId) === finger) {
        this.#actions.placesOrTakes = true;
      }
    }, HOLD);
  }

  move(event: PointerEvent, sensitivity: number): void {
    const finger = this.#fingers.get(event.pointerId);
    if (!finger) return;
    if (!finger.walks) {
      const [dx, dy] = wayOf(finger.last, event);
      this.#yaw -= dx * SENSITIVITY * sensitivity;
      this.#pitch -= dy * SENSITIVITY * sensitivity;
    }
    finger.last = event;
    if (Math.hypot(...wayOf(finger.begin, event)) > STEADY) finger.isSteady = false;
  }

  up(event: PointerEvent): void {
    const finger = this.#fingers.get(event.pointerId);
    this.#fingers.delete(event.pointerId);
    if (event.type !== "pointerup" || !finger?.isSteady) return;
    if (event.timeStamp - finger.begin.timeStamp >= TAP) return;
    const last = this.#lastTap;
    const isSecond =
      last !== null &&
      event.timeStamp - last.timeStamp < DOUBLE_TAP &&
      Math.hypot(...wayOf(last, event)) < SAME_PLACE;
    if (isSecond) this.#actions.togglesFlame = true;
    this.#lastTap = isSecond ? null : event;
  }

  /** Forgets fingers, and what no frame has read of them. */
  release(): void {
    this.#window.clearTimeout(this.#holdTimer);
    this.#fingers.clear();
    this.#lastTap = null;
    this.read();
  }

  read(): Intent {
    let [forward, right, runs] = [0, 0, false];
    for (const finger of this.#fingers.values()) {
      if (!finger.walks) continue;
      const [dx, dy] = wayOf(finger.begin, finger.last);
      const [x, y] = beyondDeadZone(dx / REACH, dy / REACH);
      if (x !== 0 || y !== 0) [forward, right] = [-y, x];
      runs = Math.hypot(dx, dy) > RUN_REACH;
    }
    const intent: Intent = {
      ...STILL,
      forward,
      right,
      runs,
      yaw: this.#yaw,
      pitch: this.#pitch,
      ...this.#actions,
    };
    this.#yaw = 0;
    this.#pitch = 0;
    this.#actions = {};
    return intent;
  }
}

function wayOf(from: PointerEvent, to: PointerEvent): [x: number, y: number] {
  return [to.clientX - from.clientX, to.clientY - from.clientY];
}
