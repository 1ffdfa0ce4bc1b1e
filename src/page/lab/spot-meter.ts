import type { CandleFlameElement } from "../../candle-flame-element.js";
import { drawnLook } from "../drawn-look.js";
import { find } from "../find.js";
import { isWalking } from "../walking.js";
import { type Radiance, type Reading, readingOf } from "./colorimetry.js";
import type { Comparison } from "./comparison.js";
import { addRows, readWhileOpen } from "./readings.js";

/** Pixels of the canvas along an edge of the spot. */
const SPOT = 5;
/** Steps of the keys, as shares of the canvas's width and height. */
const STEP = 0.01;
const LEAP = 0.1;
/** Milliseconds between readings: each draws the frame once more. */
const INTERVAL = 250;
/** Of the time that a reading takes, how long the next one waits at least: a slow machine has the rest for the room. */
const REST = 4;
const NO_UNIT = "The paper's light has no unit.";

const LIGHT: Readonly<Record<string, (reading: Reading) => string>> = {
  luminance: ({ luminance }) => `${figures(luminance)} cd/m²`,
  illuminance: ({ illuminance }) => `${figures(illuminance)} lx`,
  chromaticity: ({ x, y }) => `x ${x.toFixed(3)}, y ${y.toFixed(3)}`,
  temperature: ({ temperature }) =>
    temperature === null ? "no white" : `${Math.round(temperature / 10) * 10} K`,
};

/**
 * Spot meter: binds a spot on the canvas, moved by pointer or keys, and shows the light that comes from there.
 *
 * @returns to be called when the lab is shown or hidden
 */
export function bindSpotMeter(
  section: HTMLDetailsElement,
  spot: HTMLElement,
  room: CandleFlameElement,
  stage: HTMLElement,
  comparison: Comparison,
): () => void {
  const albedo = find(section, "[name=albedo]", HTMLInputElement);
  const status = find(section, ".status", HTMLElement);
  const values = addRows(find(section, "dl", HTMLElement), Object.keys(LIGHT));
  let place: readonly [x: number, y: number] = [0.5, 0.5];

  function moveTo(x: number, y: number): void {
    place = [Math.min(Math.max(x, 0), 1), Math.min(Math.max(y, 0), 1)];
    spot.style.left = `${place[0] * 100}%`;
    spot.style.top = `${place[1] * 100}%`;
  }

  function read(): void {
    if (document.hidden || isWalking(room)) return; // nobody sees it
    const [x, y] = place;
    const seen = comparison.roomAt(x);
    const { width, height, preparing } = seen.stats;
    const corner = (position: number, length: number) =>
      Math.round(Math.min(Math.max(position * length - SPOT / 2, 0), Math.max(length - SPOT, 0)));
    // It would compile a renderer that is being prepared at once, for seconds.
    const light = preparing
      ? null
      : seen.readRadiance(corner(x, width), corner(y, height), SPOT, SPOT);
    const reading = light && readingOf(meanOf(light), Number(albedo.value) || 0.5);
    const hasUnits = drawnLook(seen) === "physical";
    for (const [name, value] of values) {
      value.textContent = reading && hasUnits ? (LIGHT[name]?.(reading) ?? "") : "–";
    }
    if (!hasUnits) say(NO_UNIT);
    else if (status.textContent === NO_UNIT) say("");
  }

  let restUntil = 0;
  function readAtLeisure(): void {
    const begin = performance.now();
    if (begin < restUntil) return;
    read();
    const end = performance.now();
    restUntil = end + REST * (end - begin);
  }

  /** A sentence that is written again is read aloud again. */
  function say(sentence: string): void {
    if (status.textContent !== sentence) status.textContent = sentence;
  }

  spot.tabIndex = 0;
  spot.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return; // shortcuts of the browser
    const step = event.shiftKey ? LEAP : STEP;
    const ways: Readonly<Record<string, readonly [number, number]>> = {
      ArrowLeft: [-step, 0],
      ArrowRight: [step, 0],
      ArrowUp: [0, -step],
      ArrowDown: [0, step],
    };
    const way = ways[event.key];
    if (!way) return;
    event.preventDefault();
    moveTo(place[0] + way[0], place[1] + way[1]);
    read();
    // Read aloud, where the spot is moved by keys.
    if (status.textContent !== NO_UNIT) say(values.get("luminance")?.textContent ?? "");
  });
  stage.addEventListener("pointermove", ({ clientX, clientY }) => {
    if (!spot.isConnected) return;
    const { left, top, width, height } = room.getBoundingClientRect();
    moveTo((clientX - left) / width, (clientY - top) / height);
  });
  albedo.addEventListener("input", read);
  moveTo(...place);
  return readWhileOpen(section, INTERVAL, readAtLeisure, (isOpen) => {
    if (isOpen) stage.append(spot);
    else spot.remove();
  });
}

function meanOf(texels: Float32Array): Radiance {
  const sum: [number, number, number] = [0, 0, 0];
  for (let i = 0; i < texels.length; i += 3) {
    for (const channel of [0, 1, 2] as const) sum[channel] += texels[i + channel] ?? 0;
  }
  const count = Math.max(texels.length / 3, 1);
  return [sum[0] / count, sum[1] / count, sum[2] / count];
}

function figures(value: number): string {
  return new Intl.NumberFormat("en", { maximumSignificantDigits: 3 }).format(value);
}
