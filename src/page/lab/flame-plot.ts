import type { CandleFlameElement } from "../../candle-flame-element.js";
import { find } from "../find.js";
import { BINS, spectrumOf, WAVELENGTHS, wavelengthOf } from "./spectrum.js";

/** Length of the plot in the flame's own time, seconds. */
const SPAN = 10;
/** Milliseconds between samples. */
const INTERVAL = 50;
const SAMPLES_PER_SENTENCE = 20;
const WIDTH = 400;
const HEIGHT = 120;

/** Plots of the flame's luminous intensity over time, and of its spectrum now. */
export class FlamePlot {
  readonly #section: HTMLDetailsElement;
  readonly #room: CandleFlameElement;
  readonly #course: SVGPolylineElement;
  readonly #spectrum: SVGPolylineElement;
  readonly #courseScale: HTMLElement;
  readonly #spectrumScale: HTMLElement;
  readonly #words: HTMLElement;
  #samples: { readonly time: number; readonly candela: number }[] = [];
  #timer = 0;
  #sampleCount = 0;

  constructor(section: HTMLDetailsElement, room: CandleFlameElement) {
    this.#section = section;
    this.#room = room;
    this.#course = find(section, ".course polyline", SVGPolylineElement);
    this.#spectrum = find(section, ".spectrum polyline", SVGPolylineElement);
    this.#courseScale = find(section, ".course figcaption", HTMLElement);
    this.#spectrumScale = find(section, ".spectrum figcaption", HTMLElement);
    this.#words = find(section, ".status", HTMLElement);
    section.addEventListener("toggle", () => this.refresh());
  }

  /** Samples while its section is open, and the lab too. */
  refresh(): void {
    clearInterval(this.#timer);
    if (!this.#section.open || this.#section.closest("[hidden]")) return;
    this.#sampleCount = 0;
    this.#sample();
    this.#timer = window.setInterval(() => this.#sample(), INTERVAL);
  }

  #sample(): void {
    const { flame, currentTime: time } = this.#room;
    if (!flame) return;
    if (time < (this.#samples.at(-1)?.time ?? 0)) this.#samples = [];
    const candela = flame.luminousIntensity;
    if (this.#samples.at(-1)?.time !== time) this.#samples.push({ time, candela });
    this.#samples = this.#samples.filter((sample) => sample.time >= time - SPAN);
    const shown = this.#samples.map((sample) => sample.candela);
    const [least, most] = [Math.min(...shown), Math.max(...shown)];
    const top = roundUp(Math.max(most, 1e-4));
    this.#course.setAttribute(
      "points",
      pointsOf(this.#samples.map((s) => [1 - (time - s.time) / SPAN, s.candela / top])),
    );
    const hasUnits = this.#room.look === "physical";
    const unit = hasUnits ? " cd" : " of the steady flame's";
    this.#courseScale.textContent = `Luminous intensity in the last ${SPAN} s, 0 to ${top}${unit}`;
    this.#drawSpectrum(hasUnits);
    if (this.#sampleCount++ % SAMPLES_PER_SENTENCE > 0) return;
    const numbers = [candela, least, most].map((value) => value.toPrecision(3));
    this.#words.textContent = `${numbers[0]}${unit} now; ${numbers[1]} to ${numbers[2]} lately. ${Math.round(flame.colorTemperature)} K.`;
  }

  #drawSpectrum(hasUnits: boolean): void {
    const { flame } = this.#room;
    if (!flame || !hasUnits) {
      this.#spectrum.setAttribute("points", "");
      this.#spectrumScale.textContent = "The paper's light has no spectrum.";
      return;
    }
    const { luminousIntensity, blueIntensity, colorTemperature } = flame;
    const soot = luminousIntensity - blueIntensity;
    const spectrum = spectrumOf(soot, blueIntensity, colorTemperature);
    const top = roundUp(Math.max(...spectrum, 1e-12));
    this.#spectrum.setAttribute(
      "points",
      pointsOf(Array.from(spectrum, (power, bin) => [bin / (BINS - 1), power / top])),
    );
    const [first, last] = [wavelengthOf(0), WAVELENGTHS.last];
    this.#spectrumScale.textContent = `Its spectrum, ${first} to ${last} nm, 0 to ${top.toPrecision(1)} W/(sr nm)`;
  }
}

/** Shares of the width and of the height, from the lower left, as an SVG's list of points. */
function pointsOf(shares: readonly (readonly number[])[]): string {
  return shares
    .map(([x = 0, y = 0]) => `${(x * WIDTH).toFixed(1)},${((1 - y) * HEIGHT).toFixed(1)}`)
    .join(" ");
}

/** The next of 1, 2, 5, 10, … */
export function roundUp(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  const steps = [1, 2, 5, 10].map((step) => step * power);
  return steps.find((step) => step >= value) ?? value;
}
