import type { CandleFlameElement } from "../../candle-flame-element.js";
import { find } from "../find.js";
import { climb } from "./ladder.js";
import { addLadderChart } from "./ladder-chart.js";
import { createSecondRoom } from "./second-room.js";

/**
 * Binds Table 1, live: the button that measures, the progress and the results.
 *
 * What is measured is a second room over the first, which waits, untouched, until the second is removed.
 *
 * @param onChange called when a climb begins and when it has ended
 * @returns what stops a climb
 */
export function bindLadder(
  section: HTMLElement,
  room: CandleFlameElement,
  stage: HTMLElement,
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
      await Promise.race([room.ready, stopped]);
      show(false, await measureSecondRoom(signal, stopped));
    } catch (error) {
      show(false, (error as Error).message);
    }
  }

  /** Gives the sentence that says what was measured. */
  async function measureSecondRoom(signal: AbortSignal, stopped: Promise<unknown>) {
    const wasPaused = room.paused;
    room.pause();
    const second = createSecondRoom(room, "paper");
    stopAtFailure(second);
    stage.append(second);
    try {
      await Promise.race([second.ready, stopped]);
      second.mirror(room);
      second.features = room.features;
      const rounds = roundsInput.valueAsNumber;
      const frames = await climb(second, rounds, signal, (fraction, medians) => {
        progress.value = fraction;
        showMedians(medians);
      });
      const { width, height, quality } = second.stats;
      return (
        `Measured at ${width} × ${height}, quality ${quality}: medians of ${rounds} ` +
        `${rounds === 1 ? "round" : "rounds"} of ${frames} frames.`
      );
    } finally {
      second.remove();
      room.paused = wasPaused;
    }
  }

  function stopAtFailure(one: CandleFlameElement): void {
    one.addEventListener("error", ({ detail }) => stop(detail.message));
    one.addEventListener("contextlost", () => stop());
  }

  find(section, "form", HTMLFormElement).addEventListener("submit", (event) => {
    event.preventDefault();
    if (running) return stop();
    running = new AbortController();
    void measure(running);
  });
  stopAtFailure(room);
  room.addEventListener("enter", () => stop()); // one walks in the room that waits
  return stop;
}
