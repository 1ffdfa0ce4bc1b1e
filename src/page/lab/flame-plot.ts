import type { CandleFlameElement, FlameReport } from "../../candle-flame-element.js";
import { drawnLook } from "../drawn-look.js";
import { find } from "../find.js";
import { readWhileOpen } from "./readings.js";
import { BINS, spectrumOf, WAVELENGTHS, wavelengthOf } from "./spectrum.js";

/** Length of the plot in the flame's own time, seconds. */
const SPAN = 10;
/** Milliseconds between samples. */
const INTERVAL = 50;
const SAMPLES_PER_SENTENCE = 20;
const WIDTH = 400;
const HEIGHT = 120;

/**
 * Plots the flame's luminous intensity over time, and its spectrum now.
 *
 * @returns to be called when the lab is shown or hidden
 */
export function bindFlamePlot(section: HTMLDetailsElement, room: CandleFlameElement): () => void {
  const course = find(section, ".course polyline", SVGPolylineElement);
  const courseScale = find(section, ".course figcaption", HTMLElement);
  const words = find(section, ".status", HTMLElement);
  let samples: { readonly time: number; readonly candela: number }[] = [];
  let sampleCount = 0;

  function sample(): void {
    const { flame, currentTime: time } = room;
    if (!flame) return;
    if (time < (samples.at(-1)?.time ?? 0)) samples = [];
    const candela = flame.luminousIntensity;
    if (samples.at(-1)?.time !== time) samples.push({ time, candela });
    samples = samples.filter((sample) => sample.time >= time - SPAN);
    const intensities = samples.map((sample) => sample.candela);
    const [least, most] = [Math.min(...intensities), Math.max(...intensities)];
    const top = roundUp(Math.max(most, 1e-4));
    const points = samples.map((s) => [1 - (time - s.time) / SPAN, s.candela / top]);
    course.setAttribute("points", pointsOf(points));
    const hasUnits = drawnLook(room) === "physical";
    const unit = hasUnits ? " cd" : " of the steady flame's";
    courseScale.textContent = `Luminous intensity in the last ${SPAN} s, 0 to ${top}${unit}`;
    drawSpectrum(section, hasUnits ? flame : null);
    if (sampleCount++ % SAMPLES_PER_SENTENCE > 0) return;
    const numbers = [candela, least, most].map((value) => value.toPrecision(3));
    words.textContent = `${numbers[0]}${unit} now; ${numbers[1]} to ${numbers[2]} lately. ${Math.round(flame.colorTemperature)} K.`;
  }

  // Another look has another unit.
  room.addEventListener("load", () => {
    samples = [];
    sampleCount = 0;
  });
  return readWhileOpen(section, INTERVAL, sample, () => {
    sampleCount = 0;
  });
}

/** @param flame null where its light has no unit */
function drawSpectrum(section: HTMLElement, flame: FlameReport | null): void {
  const line = find(section, ".spectrum polyline", SVGPolylineElement);
  const caption = find(section, ".spectrum figcaption", HTMLElement);
  if (!flame) {
    line.setAttribute("points", "");
    caption.textContent = "The paper's light has no spectrum.";
    return;
  }
  const { luminousIntensity, blueIntensity, colorTemperature } = flame;
  const soot = luminousIntensity - blueIntensity;
  const spectrum = spectrumOf(soot, blueIntensity, colorTemperature);
  const top = roundUp(Math.max(...spectrum, 1e-12));
  const points = Array.from(spectrum, (power, bin) => [bin / (BINS - 1), power / top]);
  line.setAttribute("points", pointsOf(points));
  const [first, last] = [wavelengthOf(0), WAVELENGTHS.last];
  caption.textContent = `Its spectrum, ${first} to ${last} nm, 0 to ${top.toPrecision(1)} W/(sr nm)`;
}

/** Points of 0 to 1 across and up, from the lower left, as an SVG's list of points. */
function pointsOf(points: readonly (readonly number[])[]): string {
  return points
    .map(([x = 0, y = 0]) => `${(x * WIDTH).toFixed(1)},${((1 - y) * HEIGHT).toFixed(1)}`)
    .join(" ");
}

/** The next of 1, 2, 5, 10, … */
export function roundUp(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  const steps = [1, 2, 5, 10].map((step) => step * power);
  return steps.find((step) => step >= value) ?? value;
}
