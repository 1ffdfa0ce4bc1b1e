import { type Intent, STILL } from "../world/intent.js";

/** Radians turned per CSS pixel of pointer movement. */
const SENSITIVITY = 0.0022;
/** Browsers refuse to lock the pointer again for about this long after Esc, in milliseconds. */
const LOCK_COOL_DOWN = 1300;

/** What each key does while it is held, by its place on the keyboard, whatever the layout. */
const KEYS: Readonly<Record<string, keyof Pressed>> = {
  KeyW: "forward",
  ArrowUp: "forward",
  KeyS: "back",
  ArrowDown: "back",
  KeyA: "left",
  ArrowLeft: "left",
  KeyD: "right",
  ArrowRight: "right",
  KeyQ: "turnLeft",
  Home: "turnLeft",
  KeyR: "turnRight",
  End: "turnRight",
  PageUp: "up",
  PageDown: "down",
  ShiftLeft: "run",
  ShiftRight: "run",
};

type Wish = "placesOrTakes" | "togglesFlame" | "blows";

/** What happens once, when the key goes down. */
const WISHES: Readonly<Record<string, Wish>> = {
  KeyE: "togglesFlame",
  KeyB: "blows",
  KeyF: "placesOrTakes",
};

interface Pressed {
  forward: boolean;
  back: boolean;
  left: boolean;
  right: boolean;
  turnLeft: boolean;
  turnRight: boolean;
  up: boolean;
  down: boolean;
  run: boolean;
}

function nothingPressed(): Pressed {
  return {
    forward: false,
    back: false,
    left: false,
    right: false,
    turnLeft: false,
    turnRight: false,
    up: false,
    down: false,
    run: false,
  };
}

/**
 * Keyboard, mouse and touch, as an intent per frame.
 *
 * It listens to its host alone, and only while the visitor is in: from a click or Enter until Esc or
 * the loss of focus. The mouse looks while the pointer is locked; where a browser refuses the lock,
 * dragging looks instead.
 */
export class FirstPersonInput {
  readonly #host: HTMLElement;
  readonly #canvas: HTMLCanvasElement;
  readonly #listening = new AbortController();
  readonly #onEntered: (isIn: boolean) => void;
  #pressed = nothingPressed();
  #yaw = 0;
  #pitch = 0;
  #wishes: Partial<Record<Wish, true>> = {};
  #isIn = false;
  #wasLocked = false;
  #isFirstMove = false;
  #unlockedAt = Number.NEGATIVE_INFINITY;
  #lockTimer = 0;

  /** @param onEntered called when the visitor goes in, and when he leaves */
  constructor(host: HTMLElement, canvas: HTMLCanvasElement, onEntered: (isIn: boolean) => void) {
    this.#host = host;
    this.#canvas = canvas;
    this.#onEntered = onEntered;
    const { signal } = this.#listening;
    const { ownerDocument } = host;
    host.addEventListener("keydown", this.#keyDown, { signal });
    host.addEventListener("keyup", this.#keyUp, { signal });
    host.addEventListener("blur", () => this.leave(), { signal });
    canvas.addEventListener("click", this.#click, { signal });
    canvas.addEventListener("pointerdown", this.#pointerDown, { signal });
    canvas.addEventListener("pointermove", this.#pointerMove, { signal });
    ownerDocument.addEventListener("pointerlockchange", this.#lockChange, { signal });
    ownerDocument.addEventListener("visibilitychange", () => this.#release(), { signal });
  }

  /** What the visitor wants since the last call. */
  read(): Intent {
    const { forward, back, left, right, turnLeft, turnRight, up, down, run } = this.#pressed;
    const intent: Intent = {
      ...STILL,
      forward: Number(forward) - Number(back),
      right: Number(right) - Number(left),
      runs: run,
      turn: Number(turnLeft) - Number(turnRight),
      tilt: Number(up) - Number(down),
      yaw: this.#yaw,
      pitch: this.#pitch,
      ...this.#wishes,
    };
    this.#yaw = 0;
    this.#pitch = 0;
    this.#wishes = {};
    return intent;
  }

  get #isLocked(): boolean {
    const root = this.#canvas.getRootNode() as Document | ShadowRoot;
    return root.pointerLockElement === this.#canvas;
  }

  /** Goes in, and asks for the pointer. */
  enter(): void {
    this.#host.focus({ preventScroll: true });
    if (!this.#isIn) {
      this.#isIn = true;
      this.#onEntered(true);
    }
    if (this.#isLocked) return;
    const wait = Math.max(0, this.#unlockedAt + LOCK_COOL_DOWN - performance.now());
    clearTimeout(this.#lockTimer);
    this.#lockTimer = window.setTimeout(() => void this.#lock(), wait);
  }

  leave(): void {
    clearTimeout(this.#lockTimer);
    this.#release();
    if (this.#isLocked) this.#host.ownerDocument.exitPointerLock();
    if (!this.#isIn) return;
    this.#isIn = false;
    this.#onEntered(false);
  }

  /** Raw mouse counts where the system has them, else accelerated ones; refused, dragging remains. */
  async #lock(): Promise<void> {
    if (!this.#isIn) return;
    try {
      await this.#canvas.requestPointerLock({ unadjustedMovement: true });
    } catch (error) {
      if (!(error instanceof DOMException) || error.name !== "NotSupportedError") return;
      await Promise.resolve(this.#canvas.requestPointerLock()).catch(() => {});
    }
  }

  /** The first click goes in; under a locked pointer, the next ones are for the flame. */
  readonly #click = (): void => {
    if (this.#isIn && this.#isLocked) this.#wishes.togglesFlame = true;
    else this.enter();
  };

  readonly #lockChange = (): void => {
    if (this.#isLocked) {
      this.#isFirstMove = true;
      this.#wasLocked = true;
    } else if (this.#wasLocked) {
      this.#wasLocked = false;
      this.#unlockedAt = performance.now();
      this.leave();
    }
  };

  #release(): void {
    this.#pressed = nothingPressed();
  }

  readonly #keyDown = (event: KeyboardEvent): void => {
    if (event.code === "Enter" && !this.#isIn) {
      event.preventDefault();
      this.enter();
      return;
    }
    if (!this.#isIn || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.code === "Escape") {
      this.leave();
      return;
    }
    const action = KEYS[event.code];
    const wish = WISHES[event.code];
    if (action) this.#pressed[action] = true;
    else if (!wish) return;
    else if (!event.repeat) this.#wishes[wish] = true;
    event.preventDefault();
  };

  readonly #keyUp = (event: KeyboardEvent): void => {
    const action = KEYS[event.code];
    if (action) this.#pressed[action] = false;
  };

  readonly #pointerDown = (event: PointerEvent): void => {
    if (this.#isIn && !this.#isLocked) this.#canvas.setPointerCapture(event.pointerId);
  };

  readonly #pointerMove = (event: PointerEvent): void => {
    const isDragging = this.#isIn && event.buttons !== 0;
    if (!this.#isLocked && !isDragging) return;
    // The first move after a lock can jump (three.js #16874), and so can mice that report faster than
    // the screen redraws (a-frame #5177).
    const isJump = Math.abs(event.movementX) > window.innerWidth / 3;
    if (this.#isLocked && (this.#isFirstMove || isJump)) {
      this.#isFirstMove = false;
      return;
    }
    this.#yaw -= event.movementX * SENSITIVITY;
    this.#pitch -= event.movementY * SENSITIVITY;
  };

  dispose(): void {
    this.leave();
    this.#listening.abort();
  }
}
