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
  /** What had the focus when the page entered, until code and candle are there. */
  #entersFrom: Element | null = null;

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
      this.#entersFrom = null;
      candle.input?.dispose();
      candle.input = null;
    } else if (Input) {
      candle.input ??= new Input(this.#attributes, this.#canvas, onEntered);
      candle.input.sensitivity = sensitivity;
      const from = this.#entersFrom;
      this.#entersFrom = null;
      // Unless the visitor has gone elsewhere. What had the focus may have been hidden since.
      const { activeElement, body } = this.#canvas.ownerDocument;
      const here: (Element | null)[] = [from, body, this.#attributes];
      if (from && here.includes(activeElement)) this.enter();
    } else if (!this.#fetching) {
      const isWanted = () => this.#fetching === fetching && !this.#signal.aborted;
      const fetching = fetchInput()
        .then(() => {
          if (isWanted()) this.apply(candle, onEntered);
        })
        .catch((error: Error) => {
          if (isWanted()) this.#onMissing(error);
        });
      this.#fetching = fetching;
    }
  }

  /** Enters the room of a candle, at once or when it can be. */
  enter(): void {
    const input = this.#candle?.input;
    if (input) input.enter();
    else if (this.#attributes.controls) this.#entersFrom = this.#canvas.ownerDocument.activeElement;
  }
}
