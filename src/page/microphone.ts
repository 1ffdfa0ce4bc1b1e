import { BreathDetector, soundOf } from "./breath.js";

/** Samples of each frame: some 40 ms. */
const WINDOW = 2048;
/** Frames farther apart than this are not one breath, seconds. */
const LONGEST_FRAME = 0.1;

/** Microphone that detects blowing. Sound is measured and forgotten; nothing leaves the page. */
export class Microphone {
  readonly #stream: MediaStream;
  readonly #context = new AudioContext();
  readonly #analyser: AnalyserNode;
  readonly #samples = new Float32Array(WINDOW);
  readonly #detector = new BreathDetector();
  readonly #onBreath: (strength: number) => void;
  #lastTime = Number.NaN;
  #request: number;

  private constructor(stream: MediaStream, onBreath: (strength: number) => void) {
    this.#stream = stream;
    this.#onBreath = onBreath;
    this.#analyser = new AnalyserNode(this.#context, { fftSize: WINDOW });
    this.#context.createMediaStreamSource(stream).connect(this.#analyser);
    this.#request = requestAnimationFrame(this.#listen);
  }

  /** Asks the visitor. Rejects with a sentence for the visitor where there is none, or none is allowed. */
  static async open(onBreath: (strength: number) => void): Promise<Microphone> {
    // Phones filter wind out of speech, unless asked not to.
    const audio = { echoCancellation: false, noiseSuppression: false, autoGainControl: false };
    try {
      const stream = await navigator.mediaDevices.getUserMedia({ audio });
      return new Microphone(stream, onBreath);
    } catch (cause) {
      throw new Error(sentenceOf(cause), { cause });
    }
  }

  close(): void {
    cancelAnimationFrame(this.#request);
    for (const track of this.#stream.getTracks()) track.stop();
    void this.#context.close();
  }

  readonly #listen = (milliseconds: DOMHighResTimeStamp): void => {
    this.#request = requestAnimationFrame(this.#listen);
    const elapsed = (milliseconds - this.#lastTime) / 1000;
    this.#lastTime = milliseconds;
    if (!(elapsed > 0)) return;
    this.#analyser.getFloatTimeDomainData(this.#samples);
    const sound = soundOf(this.#samples, this.#context.sampleRate);
    const strength = this.#detector.hear(sound, Math.min(elapsed, LONGEST_FRAME));
    if (strength > 0) this.#onBreath(strength);
  };
}

function sentenceOf(cause: unknown): string {
  const name = cause instanceof Error || cause instanceof DOMException ? cause.name : "";
  if (name === "NotAllowedError") return "The browser keeps the microphone from this page.";
  if (name === "NotFoundError") return "No microphone was found.";
  if (!navigator.mediaDevices) return "This browser has no microphone for this page.";
  return "The microphone could not be opened.";
}
