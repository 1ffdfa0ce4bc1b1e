import { windowOf } from "../window-of.js";
import { type Action, type Intent, STILL } from "../world/player/intent.js";
import { describeControls } from "./describe-controls.js";
import { Gamepads, hasEntering, type Pad } from "./gamepads.js";
import { Keyboard } from "./keyboard.js";
import { Touch } from "./touch.js";

/** Radians turned per CSS pixel of pointer movement. */
const SENSITIVITY = 0.0022;
/** Keys that enter the room. */
const ENTER: ReadonlySet<string> = new Set(["Enter", "NumpadEnter"]);
/** Browsers refuse to lock the pointer again for about this long after Esc, in milliseconds. */
const LOCK_COOL_DOWN = 1300;

/** In hand; a mouse drags where the browser refuses to lock its pointer. */
export type Device = "mouse" | "drag" | "keyboard" | "touch" | "gamepad";

/**
 * Keyboard, mouse, touch and gamepad, as an intent per frame.
 *
 * It listens to its host alone, and only while the visitor is in the room: from a click, a tap, Enter or a
 * gamepad's A until Esc or the loss of focus. The mouse turns the view while the pointer is locked; where a browser
 * refuses the lock, dragging does.
 */
export class FirstPersonInput {
  /** Factor to how far mouse and fingers turn the view. */
  sensitivity = 1;
  readonly describe = describeControls;
  readonly #host: HTMLElement;
  readonly #canvas: HTMLCanvasElement;
  readonly #window: Window;
  readonly #listening = new AbortController();
  readonly #onEntered: (isIn: boolean, device: Device) => void;
  readonly #keyboard = new Keyboard();
  readonly #touch: Touch;
  readonly #gamepads = new Gamepads();
  #yaw = 0;
  #pitch = 0;
  #clicks = false;
  #isIn = false;
  #isTouched = false;
  /** Whether a key was the last input to the page. */
  #isByKey = false;
  /** What a mouse is, by the browser's last answer to a request for the lock. */
  #mouse: "mouse" | "drag" = "mouse";
  /** Whether the visitor went in by mouse. */
  #isByMouse = false;
  /** Whether an event is to answer such a request, in browsers that return no promise. */
  #awaitsLock = false;
  /** Whether the next click within asks once more. */
  #asksAgain = false;
  #wasLocked = false;
  #isFirstMove = false;
  #wasFast = false;
  #unlockedAt = Number.NEGATIVE_INFINITY;
  #lockTimer = 0;

  /** @param onEntered called when the visitor goes in, by which device, if that proves to be another, and on leaving */
  constructor(
    host: HTMLElement,
    canvas: HTMLCanvasElement,
    onEntered: (isIn: boolean, device: Device) => void,
  ) {
    this.#host = host;
    this.#canvas = canvas;
    this.#window = windowOf(host);
    this.#touch = new Touch(this.#window);
    this.#onEntered = onEntered;
    const { signal } = this.#listening;
    const { ownerDocument } = host;
    host.addEventListener("keydown", this.#keyDown, { signal });
    host.addEventListener("keyup", (event) => this.#keyboard.lift(event), { signal });
    host.addEventListener("blur", () => this.leave(), { signal });
    host.addEventListener("click", this.#click, { signal });
    canvas.addEventListener("pointerdown", this.#pointerDown, { signal });
    canvas.addEventListener("pointermove", this.#pointerMove, { signal });
    canvas.addEventListener("pointerup", this.#pointerUp, { signal });
    canvas.addEventListener("pointercancel", this.#pointerUp, { signal });
    canvas.addEventListener("contextmenu", this.#contextMenu, { signal });
    // Of a button that enters, too.
    const notePointer = ({ pointerType }: PointerEvent) => {
      this.#isTouched = pointerType === "touch";
      this.#isByKey = false;
    };
    const noteKey = () => {
      this.#isByKey = true;
    };
    ownerDocument.addEventListener("pointerdown", notePointer, { signal, capture: true });
    ownerDocument.addEventListener("keydown", noteKey, { signal, capture: true });
    ownerDocument.addEventListener("click", this.#clickAnywhere, { signal, capture: true });
    ownerDocument.addEventListener("pointerlockchange", this.#lockChange, { signal });
    ownerDocument.addEventListener("pointerlockerror", this.#lockError, { signal });
    ownerDocument.addEventListener("visibilitychange", () => this.#release(), { signal });
  }

  /** Whether the visitor is in the room. */
  get isIn(): boolean {
    return this.#isIn;
  }

  /** Intent since the last call. */
  read(): Intent {
    const intents = [this.#readGamepads(), this.#keyboard.read(), this.#touch.read()];
    const sum = (name: "forward" | "right" | "turn" | "tilt" | "yaw" | "pitch") =>
      intents.reduce((sum, intent) => sum + intent[name], 0);
    const atMost1 = (value: number) => Math.min(1, Math.max(-1, value));
    const any = (name: "runs" | Action) => intents.some((intent) => intent[name]);
    const intent: Intent = {
      forward: atMost1(sum("forward")),
      right: atMost1(sum("right")),
      turn: atMost1(sum("turn")),
      tilt: atMost1(sum("tilt")),
      runs: any("runs"),
      yaw: this.#yaw + sum("yaw"),
      pitch: this.#pitch + sum("pitch"),
      placesOrTakes: any("placesOrTakes"),
      togglesFlame: this.#clicks || any("togglesFlame"),
      blows: any("blows"),
    };
    this.#forgetMouse();
    return intent;
  }

  /** Intent of the gamepads, which also enter and leave the room while the host has the focus. */
  #readGamepads(): Intent {
    // Of a window in the background, the focus is remembered.
    const hasFocus = this.#host.matches(":focus") && this.#host.ownerDocument.hasFocus();
    if (!this.#isIn && !hasFocus) {
      this.#gamepads.release();
      return STILL;
    }
    const intent = this.#gamepads.read(connectedGamepads(this.#window));
    const wasIn = this.#isIn;
    if (!wasIn && this.#gamepads.enters) this.#goIn("gamepad");
    if (wasIn && this.#gamepads.leaves) this.leave();
    return wasIn && this.#isIn ? intent : STILL;
  }

  get #isLocked(): boolean {
    const root = this.#canvas.getRootNode() as Document | ShadowRoot;
    return root.pointerLockElement === this.#canvas;
  }

  /**
   * Enters the room, and locks the pointer of a mouse.
   *
   * @param device in hand. Default: the one that was used last
   */
  enter(device?: Device): void {
    // A page may mind gamepads, too. Their buttons are no gestures by which browsers lock the pointer.
    if (!device && hasEntering(connectedGamepads(this.#window))) {
      this.#goIn("gamepad");
      return;
    }
    const hasMouse = !this.#isTouched && this.#window.matchMedia("(any-pointer: fine)").matches;
    const pointer = hasMouse ? this.#mouse : "touch";
    this.#goIn(device ?? (this.#isByKey ? "keyboard" : pointer));
    if (!this.#isIn || !hasMouse || this.#isLocked) return;
    const wait = Math.max(0, this.#unlockedAt + LOCK_COOL_DOWN - performance.now());
    this.#window.clearTimeout(this.#lockTimer);
    this.#lockTimer = this.#window.setTimeout(() => void this.#lock(), wait);
  }

  #goIn(device: Device): void {
    this.#host.focus({ preventScroll: true });
    // What is inert, or whose tabindex the page has removed, takes no focus, and would never lose it.
    const { activeElement } = this.#host.getRootNode() as Document | ShadowRoot;
    if (this.#isIn || activeElement !== this.#host) return;
    this.#isIn = true;
    this.#isByMouse = device === this.#mouse;
    this.#asksAgain = true;
    this.#gamepads.release();
    this.#onEntered(true, device);
  }

  leave(): void {
    this.#window.clearTimeout(this.#lockTimer);
    this.#release();
    const wasIn = this.#isIn;
    this.#isIn = false;
    this.#freeOutside();
    if (wasIn) this.#onEntered(false, "keyboard");
  }

  /** A browser may grant the lock only after the visitor has left. */
  #freeOutside(): void {
    if (!this.#isIn && this.#isLocked) this.#host.ownerDocument.exitPointerLock();
  }

  /** Raw mouse counts where the system has them, else accelerated ones; refused, dragging remains. */
  async #lock(): Promise<void> {
    if (!this.#isIn) return;
    try {
      const answer: unknown = this.#canvas.requestPointerLock({ unadjustedMovement: true });
      this.#awaitsLock = !answer;
      await answer;
    } catch (error) {
      if (!(error instanceof DOMException) || error.name !== "NotSupportedError") {
        this.#becomes("drag");
        return;
      }
      if (!this.#isIn) return;
      await Promise.resolve(this.#canvas.requestPointerLock()).catch(() => this.#becomes("drag"));
    }
    this.#freeOutside();
  }

  /** The mouse proves to be locked, or to drag. An answer to a visitor who has left says nothing. */
  #becomes(mouse: "mouse" | "drag"): void {
    if (!this.#isIn || this.#isLocked !== (mouse === "mouse")) return;
    const isOther = mouse !== this.#mouse;
    this.#mouse = mouse;
    if (isOther && this.#isByMouse) this.#onEntered(true, mouse);
  }

  /**
   * The first click enters the room; with a locked pointer, further clicks are for the flame. Without, the next one
   * asks for it again: browsers want a gesture, which a page that entered may have lacked. No further one does, since
   * each click ends a drag, and browsers write each refusal to the console.
   */
  readonly #click = (event: MouseEvent): void => {
    const [target] = event.composedPath();
    if (target !== this.#canvas && target !== this.#host) return; // of a control in a slot
    if (this.#isIn && this.#isLocked) this.#clicks = true;
    else if (!this.#isIn) this.enter();
    else if (this.#asksAgain && !this.#isTouched) {
      this.#asksAgain = false;
      this.enter();
    }
  };

  readonly #lockError = (): void => {
    if (this.#awaitsLock) this.#becomes("drag");
    this.#awaitsLock = false;
  };

  readonly #lockChange = (): void => {
    if (this.#isLocked) {
      this.#awaitsLock = false;
      this.#becomes("mouse");
      this.#isFirstMove = true;
      this.#wasLocked = true;
      this.#freeOutside();
    } else if (this.#wasLocked) {
      this.#wasLocked = false;
      this.#unlockedAt = performance.now();
      this.leave();
    }
  };

  #release(): void {
    this.#keyboard.release();
    this.#touch.release();
    this.#gamepads.release();
    this.#forgetMouse();
  }

  #forgetMouse(): void {
    this.#yaw = 0;
    this.#pitch = 0;
    this.#clicks = false;
  }

  readonly #keyDown = (event: KeyboardEvent): void => {
    const { code, target, ctrlKey, metaKey, altKey } = event;
    // Not of a control in a slot.
    if (target !== this.#host || ctrlKey || metaKey || altKey) return;
    if (this.#isIn) {
      if (code === "Escape") this.leave();
      else if (!this.#keyboard.press(event)) return;
    } else if (code !== "Escape" || !event.repeat) {
      if (!ENTER.has(code) || event.repeat) return;
      this.#isTouched = false;
      this.enter("keyboard");
    }
    event.preventDefault(); // Esc would close the dialog around it, too, as it would held down
  };

  readonly #pointerDown = (event: PointerEvent): void => {
    if (!this.#isIn || this.#isLocked) return;
    if (this.#isTouched) this.#touch.down(event, this.#canvas.getBoundingClientRect());
    if (event.isTrusted) this.#canvas.setPointerCapture(event.pointerId); // a script may have made it
  };

  readonly #pointerMove = (event: PointerEvent): void => {
    if (event.pointerType === "touch") {
      this.#touch.move(event, this.sensitivity);
      return;
    }
    const isDragging = this.#isIn && event.buttons !== 0;
    if (!this.#isLocked && !isDragging) return;
    // The first move after a lock can jump (three.js #16874), and so can mice that report faster than
    // the screen redraws (a-frame #5177): once, where a fast hand makes several long moves.
    const isFast = Math.hypot(event.movementX, event.movementY) > this.#window.screen.width / 3;
    const isJump = this.#isFirstMove || (isFast && !this.#wasFast);
    this.#isFirstMove = false;
    this.#wasFast = isFast;
    if (this.#isLocked && isJump) return;
    this.#yaw -= event.movementX * SENSITIVITY * this.sensitivity;
    this.#pitch -= event.movementY * SENSITIVITY * this.sensitivity;
  };

  readonly #pointerUp = (event: PointerEvent): void => this.#touch.up(event);

  /** A long press puts the candle down, and opens no menu. */
  readonly #contextMenu = (event: Event): void => {
    if (this.#isIn && this.#isTouched) event.preventDefault();
  };

  /**
   * Leaves on a click elsewhere, since not all browsers move the focus on touch. In the capture phase, because the
   * click may be on a button that enters; not on `pointerdown`, after which the page may hide that button.
   */
  readonly #clickAnywhere = (event: MouseEvent): void => {
    const path = event.composedPath();
    if (path.includes(this.#host)) return;
    // Of a click in a closed shadow tree only its host is known.
    let { host } = this.#host.getRootNode() as ShadowRoot;
    while (host && host !== path[0]) ({ host } = host.getRootNode() as ShadowRoot);
    if (!host) this.leave();
  };

  dispose(): void {
    this.leave();
    this.#listening.abort();
  }
}

/** Gamepads that the browser shows us: none before one of their buttons was pressed. */
function connectedGamepads({ navigator }: Window): readonly (Pad | null)[] {
  try {
    return navigator.getGamepads?.() ?? [];
  } catch {
    return []; // a frame whose permissions policy forbids them
  }
}
