import type { CandleFlame } from "../candle-flame.js";
import type { Device } from "../input/first-person-input.js";
import { cameraOf } from "./camera.js";
import type { CustomStates } from "./custom-states.js";
import { emit } from "./events.js";
import { changeSentence, REFUSALS, reachedSentence } from "./messages.js";
import type { Overlay } from "./overlay.js";
import type { ReflectedAttributes } from "./reflected-attributes.js";

/** Reports what the candle does: by the element's events and states, by hints, and by the glow on the page. */
export class CandleReporter {
  readonly #element: ReflectedAttributes;
  readonly #states: CustomStates;
  readonly #overlay: Overlay;
  /** The one that is watched. */
  #candle: CandleFlame | null = null;
  #camera = "";
  /** Device of a visitor who has entered while time stands: controls do nothing then, and are not shown. */
  #enteredBy: Device | null = null;

  constructor(element: ReflectedAttributes, states: CustomStates, overlay: Overlay) {
    this.#element = element;
    this.#states = states;
    this.#overlay = overlay;
  }

  /** Reports from now on what happens in a new candle's frames. */
  watch(candle: CandleFlame): void {
    const element = this.#element;
    this.#candle = candle;
    candle.onCandleMoved = (isHeld) => emit(element, isHeld ? "take" : "place", null);
    // Later: a page that sets the look listens afterwards.
    candle.onLookChanged = () => queueMicrotask(() => emit(element, "load", null));
    candle.onRefused = () => this.refusal(candle);
    const detailOf = (index: number) => ({ index, name: candle.candleNames[index] ?? "" });
    const { hint } = this.#overlay;
    candle.onWickReached = (index) => {
      this.#tellControls(candle);
      hint.tell(reachedSentence(detailOf(index), hint.lighting));
    };
    candle.view.onQualityChanged = () => emit(element, "qualitychange", null);
    candle.onFlameChanged = (index, isLit) => {
      this.flame(candle, index > 0 ? changeSentence(detailOf(index), isLit) : null);
      emit(element, isLit ? "light" : "extinguish", detailOf(index));
    };
    this.#camera = keyOf(candle);
  }

  /** The candle's session has ended. What it still reports is no longer shown. */
  stop(): void {
    this.#candle = null;
    this.#states.clear();
  }

  /** Time has passed, or was stepped. */
  frame(candle: CandleFlame): void {
    this.#tellControls(candle);
    this.camera(candle);
    this.glow(candle);
  }

  camera(candle: CandleFlame): void {
    const key = keyOf(candle);
    if (key === this.#camera) return;
    this.#camera = key;
    emit(this.#element, "camerachange", null);
  }

  glow(candle: CandleFlame): void {
    if (this.#states.has("alone")) this.#overlay.glow(candle.luminousIntensity);
  }

  flame(candle: CandleFlame, news: string | null = null): void {
    if (candle !== this.#candle) return;
    const { flame } = candle.world;
    this.#states.toggle("lit", flame.isLit);
    // Keys and gestures reach the candle while the visitor walks.
    const canLight = this.#states.has("walking") && !this.#enteredBy;
    this.#overlay.hint.tellFlame(flame.isLit, canLight, news);
  }

  /** The visitor has entered the room, or left it; or the device in his hand proves to be another. */
  entered(candle: CandleFlame, isIn: boolean, device: Device): void {
    const isOtherDevice = isIn && this.#states.has("walking");
    this.#states.toggle("walking", isIn);
    this.#enteredBy = isIn ? device : null;
    if (!isIn) this.flame(candle);
    else if (this.#states.has("playing")) this.#tellControls(candle);
    if (isOtherDevice) return;
    // Later: the canvas may be on its way out, and a listener may want another.
    queueMicrotask(() => emit(this.#element, isIn ? "enter" : "leave", null));
  }

  #tellControls({ input }: CandleFlame): void {
    const device = this.#enteredBy;
    this.#enteredBy = null;
    const line = device && input?.describe(device, this.#states.has("alone"));
    if (device && line) this.#overlay.hint.tellControls(device, line);
  }

  /** Shows why the candle could not be put down, or taken up. */
  refusal(candle: CandleFlame): void {
    const { refusal } = candle.world;
    this.flame(candle, refusal && REFUSALS[refusal]);
  }
}

function keyOf(candle: CandleFlame): string {
  const { position, yaw, pitch, fieldOfView } = cameraOf(candle);
  return `${position} ${yaw} ${pitch} ${fieldOfView}`;
}
