import type { CandleFlameElement } from "../../candle-flame-element.js";
import { find } from "../find.js";
import { isWalking } from "../walking.js";
import { climb } from "./ladder.js";
import { LadderChart } from "./ladder-chart.js";

/** Table 1, live: the button that measures, the progress and the results. */
export class LadderSection {
  /** Called when a climb begins and when it has ended. */
  onChange: (isRunning: boolean) => void = () => {};
  readonly #element: CandleFlameElement;
  readonly #chart: LadderChart;
  readonly #rounds: HTMLInputElement;
  readonly #button: HTMLButtonElement;
  readonly #progress: HTMLProgressElement;
  readonly #status: HTMLElement;
  #running: AbortController | null = null;

  constructor(section: HTMLElement, element: CandleFlameElement) {
    this.#element = element;
    this.#chart = new LadderChart(find(section, "tbody", HTMLTableSectionElement));
    this.#rounds = find(section, "[name=rounds]", HTMLInputElement);
    this.#button = find(section, ".measure", HTMLButtonElement);
    this.#progress = find(section, "progress", HTMLProgressElement);
    this.#status = find(section, ".status", HTMLElement);
    find(section, "form", HTMLFormElement).addEventListener("submit", (event) => {
      event.preventDefault();
      if (this.#running) this.stop();
      else void this.#run(new AbortController());
    });
    for (const type of ["error", "contextlost"] as const) {
      element.addEventListener(type, () => this.stop());
    }
  }

  stop(): void {
    this.#running?.abort();
  }

  async #run(running: AbortController): Promise<void> {
    const element = this.#element;
    this.#running = running;
    this.#show(true, "");
    try {
      await element.ready;
      const rounds = this.#rounds.valueAsNumber;
      const { medians, frames } = await climb(element, {
        rounds,
        signal: running.signal,
        onProgress: (share, medians) => {
          this.#progress.value = share;
          this.#chart.show(medians);
          // Walking changes the view, and with it what is measured.
          if (isWalking(element)) running.abort();
        },
      });
      this.#chart.show(medians);
      const { width, height, quality } = element.stats;
      this.#show(
        false,
        `Measured at ${width} × ${height}, quality ${quality}: medians of ${rounds} ` +
          `${rounds === 1 ? "round" : "rounds"} of ${frames} frames.`,
      );
    } catch (error) {
      if (!running.signal.aborted) this.#show(false, (error as Error).message);
      else this.#show(false, "Stopped before the end.");
    }
  }

  #show(isRunning: boolean, sentence: string): void {
    if (!isRunning) this.#running = null;
    this.#button.textContent = isRunning ? "Stop" : "Measure";
    this.#rounds.disabled = isRunning;
    this.#progress.hidden = !isRunning;
    this.#progress.value = 0;
    this.#status.textContent = sentence;
    this.onChange(isRunning);
  }
}
