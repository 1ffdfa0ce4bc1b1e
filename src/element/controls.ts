import type { CandleFlame } from "../candle-flame.js";
import { fetchedInput, fetchInput } from "../create-candle.js";
import type { Device } from "../input/first-person-input.js";
import type { ReflectedAttributes } from "./reflected-attributes.js";

type OnEntered = (isIn: boolean, device: Device) => void;

/** Controls of a session's candle, if the attributes ask for them; their code is fetched then, at the latest. */
export class Controls {
  readonly #attributes: ReflectedAttributes;
  readonly #canvas: HTMLCanvasElement;
  readonly #signal: AbortSignal;
  readonly #onMissing: (error: Error) => void;
  #candle: CandleFlame | null = null;
  /** Their code, as it was asked for since the attribute was set. */
  #fetching: Promise<void> | null = null;
  /** So many times. */
  #fetches = 0;
  /** Whether the page enters once code and candle are there. */
  #entersSoon = false;

  /** @param onMissing called when their code could not be fetched, until the signal aborts */
  constructor(
    attributes: ReflectedAttributes,
    canvas: HTMLCanvasElement,
    signal: AbortSignal,
    onMissing: (error: Error) => void,
  ) {
    this.#attributes = attributes;
    this.#canvas = canvas;
    this.#signal = signal;
    this.#onMissing = onMissing;
  }

  /** Resolves when the code that was asked for is there, or cannot be had. */
  get settled(): Promise<void> | null {
    return this.#fetching;
  }

  /** Gives the visitor the controls, or takes them, as the attributes say. */
  apply(candle: CandleFlame, onEntered: OnEntered): void {
    const { controls, sensitivity } = this.#attributes;
    const Input = fetchedInput();
    this.#candle = candle;
    if (!controls) {
      this.#fetching = null;
      this.#entersSoon = false;
      candle.input?.dispose();
      candle.input = null;
    } else if (Input) {
      candle.input ??= new Input(this.#attributes, this.#canvas, onEntered);
      candle.input.sensitivity = sensitivity;
      if (this.#entersSoon) this.enter();
    } else {
      this.#fetching ??= this.#fetch(candle, onEntered);
    }
  }

  async #fetch(candle: CandleFlame, onEntered: OnEntered): Promise<void> {
    const fetches = ++this.#fetches;
    const isWanted = () =>
      !this.#signal.aborted && this.#attributes.controls && fetches === this.#fetches;
    try {
      await fetchInput();
      if (!isWanted()) return;
      this.apply(candle, onEntered);
    } catch (error) {
      if (isWanted()) this.#onMissing(error as Error);
    }
  }

  /** Enters the room of a candle, at once or when it can be. */
  enter(): void {
    const input = this.#candle?.input;
    this.#entersSoon = !input && this.#attributes.controls;
    input?.enter();
  }
}
