import type { CandleFlame } from "../candle-flame.js";
import type { Device } from "../input/first-person-input.js";
import { cameraOf } from "./camera-control.js";
import type { CustomStates } from "./custom-states.js";
import { emit } from "./events.js";
import type { Glow } from "./glow.js";
import type { Hint } from "./hint.js";
import { reachedSentence } from "./messages.js";
import type { ReflectedAttributes } from "./reflected-attributes.js";

/** Reports what the candle does: by the element's events and states, by hints, and by the glow on the page. */
export class CandleReporter {
  readonly #element: ReflectedAttributes;
  readonly #states: CustomStates;
  readonly #hint: Hint;
  readonly #glow: Glow;
  #camera = "";

  constructor(element: ReflectedAttributes, states: CustomStates, hint: Hint, glow: Glow) {
    this.#element = element;
    this.#states = states;
    this.#hint = hint;
    this.#glow = glow;
  }

  /** Reports from now on what happens in a new candle's frames. */
  watch(candle: CandleFlame): void {
    const element = this.#element;
    candle.onCandleMoved = () => emit(element, candle.world.candle.isHeld ? "take" : "place", null);
    candle.onLookChanged = () => emit(element, "load", null);
    candle.onRefused = () => this.refusal(candle);
    candle.onWickReached = (index) => {
      const name = candle.candleNames[index] ?? "";
      this.#hint.tell(reachedSentence({ index, name }));
    };
    candle.view.onQualityChanged = () => emit(element, "qualitychange", null);
    candle.onFlameChanged = (index) => {
      const name = candle.candleNames[index] ?? "";
      const isLit = candle.isLit(index);
      this.flame(candle);
      if (index > 0) this.#hint.tellOther({ index, name, isLit }, candle.isLit(0), this.#isWalking);
      emit(element, isLit ? "light" : "extinguish", { index, name });
    };
    this.#camera = keyOf(candle);
  }

  /** Whether keys and gestures reach the candle. */
  get #isWalking(): boolean {
    return this.#states.has("walking");
  }

  frame(candle: CandleFlame): void {
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
    if (this.#states.has("alone")) this.#glow.follow(candle.luminousIntensity);
  }

  flame({ world: { flame } }: CandleFlame): void {
    this.#states.toggle("lit", flame.isLit);
    this.#hint.tellFlame(flame.isLit, this.#isWalking);
  }

  /** The visitor has entered the room, or left it. */
  entered(candle: CandleFlame, isIn: boolean, device: Device): void {
    this.#states.toggle("walking", isIn);
    if (isIn) this.#hint.tellControls(device);
    else this.flame(candle);
    emit(this.#element, isIn ? "enter" : "leave", null);
  }

  /** Shows why the candle could not be put down. */
  refusal({ world: { flame, refusal } }: CandleFlame): void {
    this.#hint.tellRefusal(refusal, flame.isLit, this.#isWalking);
  }
}

function keyOf(candle: CandleFlame): string {
  const { position, yaw, pitch, fieldOfView } = cameraOf(candle);
  return `${position} ${yaw} ${pitch} ${fieldOfView}`;
}
