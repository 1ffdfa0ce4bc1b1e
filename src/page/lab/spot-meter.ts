import type { CandleFlameElement } from "../../candle-flame-element.js";
import { find } from "../find.js";
import { type Radiance, type Reading, readingOf } from "./colorimetry.js";
import { addRows } from "./readings.js";

/** Pixels of the canvas along an edge of the spot. */
const SPOT = 5;
/** Steps of the keys, as shares of the canvas's width and height. */
const STEP = 0.01;
const LEAP = 0.1;
/** Milliseconds between readings: each draws the frame once more. */
const INTERVAL = 250;

const LIGHT: Readonly<Record<string, (reading: Reading) => string>> = {
  luminance: ({ luminance }) => `${figures(luminance)} cd/m²`,
  illuminance: ({ illuminance }) => `${figures(illuminance)} lx`,
  chromaticity: ({ x, y }) => `x ${x.toFixed(3)}, y ${y.toFixed(3)}`,
  temperature: ({ temperature }) =>
    temperature === null ? "no white" : `${Math.round(temperature / 10) * 10} K`,
};

/** Spot meter: a spot on the canvas, moved by pointer or keys, and the light that comes from there. */
export class SpotMeter {
  readonly #section: HTMLDetailsElement;
  readonly #room: CandleFlameElement;
  readonly #stage: HTMLElement;
  readonly #albedo: HTMLInputElement;
  readonly #values: ReadonlyMap<string, HTMLElement>;
  readonly #spot: HTMLElement;
  readonly #status: HTMLElement;
  #place: readonly [x: number, y: number] = [0.5, 0.5];
  #timer = 0;

  constructor(
    section: HTMLDetailsElement,
    spot: HTMLElement,
    room: CandleFlameElement,
    stage: HTMLElement,
  ) {
    this.#section = section;
    this.#spot = spot;
    this.#room = room;
    this.#stage = stage;
    this.#albedo = find(section, "[name=albedo]", HTMLInputElement);
    this.#status = find(section, ".status", HTMLElement);
    this.#values = addRows(find(section, "dl", HTMLElement), Object.keys(LIGHT));
    spot.tabIndex = 0;
    spot.addEventListener("keydown", (event) => {
      if (this.#pressKey(event)) event.preventDefault();
    });
    stage.addEventListener("pointermove", ({ clientX, clientY }) => {
      if (!spot.isConnected) return;
      const { left, top, width, height } = room.getBoundingClientRect();
      this.#moveTo((clientX - left) / width, (clientY - top) / height);
    });
    section.addEventListener("toggle", () => this.refresh());
    this.#albedo.addEventListener("input", () => this.#read());
  }

  /** Measures while its section is open, and the lab too. */
  refresh(): void {
    clearInterval(this.#timer);
    if (!this.#section.open || this.#section.closest("[hidden]")) {
      this.#spot.remove();
      return;
    }
    this.#stage.append(this.#spot);
    this.#moveTo(...this.#place);
    this.#timer = window.setInterval(() => this.#read(), INTERVAL);
  }

  #pressKey({ key, shiftKey }: KeyboardEvent): boolean {
    const step = shiftKey ? LEAP : STEP;
    const ways: Readonly<Record<string, readonly [number, number]>> = {
      ArrowLeft: [-step, 0],
      ArrowRight: [step, 0],
      ArrowUp: [0, -step],
      ArrowDown: [0, step],
    };
    const way = ways[key];
    if (!way) return false;
    this.#moveTo(this.#place[0] + way[0], this.#place[1] + way[1]);
    this.#read();
    const luminance = this.#values.get("luminance")?.textContent ?? "";
    this.#status.textContent = luminance; // read aloud, where one moves by keys
    return true;
  }

  #moveTo(x: number, y: number): void {
    this.#place = [Math.min(Math.max(x, 0), 1), Math.min(Math.max(y, 0), 1)];
    this.#spot.style.left = `${this.#place[0] * 100}%`;
    this.#spot.style.top = `${this.#place[1] * 100}%`;
  }

  #read(): void {
    const { width, height } = this.#room.stats;
    const corner = (share: number, length: number) =>
      Math.round(Math.min(Math.max(share * length - SPOT / 2, 0), Math.max(length - SPOT, 0)));
    const [x, y] = this.#place;
    const [columns, rows] = [Math.min(SPOT, width), Math.min(SPOT, height)];
    const light =
      columns * rows > 0
        ? this.#room.readRadiance(corner(x, width), corner(y, height), columns, rows)
        : new Float32Array(0);
    const albedo = Number(this.#albedo.value) || 0.5;
    const reading = readingOf(meanOf(light), albedo);
    const hasUnits = this.#room.look === "physical";
    for (const [name, value] of this.#values) {
      value.textContent = reading && hasUnits ? (LIGHT[name]?.(reading) ?? "") : "–";
    }
    if (!hasUnits) this.#status.textContent = "The paper's light has no unit.";
    else if (this.#status.textContent?.startsWith("The paper")) this.#status.textContent = "";
  }
}

function meanOf(texels: Float32Array): Radiance {
  const sum: [number, number, number] = [0, 0, 0];
  for (let i = 0; i < texels.length; i++) sum[(i % 3) as 0 | 1 | 2] += texels[i] ?? 0;
  const count = Math.max(texels.length / 3, 1);
  return [sum[0] / count, sum[1] / count, sum[2] / count];
}

function figures(value: number): string {
  return new Intl.NumberFormat("en", { maximumSignificantDigits: 3 }).format(value);
}
