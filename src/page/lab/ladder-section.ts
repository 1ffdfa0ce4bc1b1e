import type { CandleFlameElement } from "../../candle-flame-element.js";
import { find } from "../find.js";
import { isWalking } from "../walking.js";
import { climb } from "./ladder.js";
import { addLadderChart } from "./ladder-chart.js";

/**
 * Binds Table 1, live: the button that measures, the progress and the results.
 *
 * @param onChange called when a climb begins and when it has ended
 * @returns what stops a climb
 */
export function bindLadder(
  section: HTMLElement,
  element: CandleFlameElement,
  onChange: (isRunning: boolean) => void,
): () => void {
  const showMedians = addLadderChart(find(section, "tbody", HTMLTableSectionElement));
  const roundsInput = find(section, "[name=rounds]", HTMLInputElement);
  const button = find(section, ".measure", HTMLButtonElement);
  const progress = find(section, "progress", HTMLProgressElement);
  const status = find(section, ".status", HTMLElement);
  let running: AbortController | null = null;
  const stop = (sentence = "Stopped before the end.") => running?.abort(new Error(sentence));

  function show(isRunning: boolean, sentence: string): void {
    if (!isRunning) running = null;
    button.textContent = isRunning ? "Stop" : "Measure";
    roundsInput.readOnly = isRunning; // disabled, it would lose the focus
    progress.hidden = !isRunning;
    progress.value = 0;
    status.textContent = sentence;
    onChange(isRunning);
  }

  async function measure({ signal }: AbortController): Promise<void> {
    show(true, "");
    const stopped = new Promise((_, reject) => {
      signal.addEventListener("abort", () => reject(signal.reason));
    });
    try {
      await Promise.race([element.ready, stopped]);
      signal.throwIfAborted();
      const rounds = roundsInput.valueAsNumber;
      const frames = await climb(element, rounds, signal, (fraction, medians) => {
        progress.value = fraction;
        showMedians(medians);
        // Walking changes the view, and with it what is measured.
        if (isWalking(element)) stop();
      });
      const { width, height, quality } = element.stats;
      show(
        false,
        `Measured at ${width} × ${height}, quality ${quality}: medians of ${rounds} ` +
          `${rounds === 1 ? "round" : "rounds"} of ${frames} frames.`,
      );
    } catch (error) {
      show(false, (error as Error).message);
    }
  }

  find(section, "form", HTMLFormElement).addEventListener("submit", (event) => {
    event.preventDefault();
    if (running) return stop();
    running = new AbortController();
    void measure(running);
  });
  element.addEventListener("error", ({ detail }) => stop(detail.message));
  element.addEventListener("contextlost", () => stop());
  return stop;
}
