import { expect, test } from "vitest";
import { FlashMeter } from "../support/flash.js";

const [WIDTH, HEIGHT, RATE] = [64, 48, 60];
type Color = readonly [red: number, green: number, blue: number];

/** Two seconds of a square on black, as large as this share of a field, in a colour that varies. */
function watch(share: number, colorAt: (seconds: number) => Color): FlashMeter {
  const meter = new FlashMeter(WIDTH, HEIGHT);
  const side = Math.round(Math.sqrt(share * (WIDTH / 3) * (HEIGHT / 3)));
  const frame = new Uint8ClampedArray(WIDTH * HEIGHT * 4);
  for (let n = 0; n < 2 * RATE; n++) {
    const color = colorAt(n / RATE);
    for (let y = 0; y < side; y++) {
      for (let x = 0; x < side; x++) frame.set(color, ((y + 9) * WIDTH + x + 20) * 4);
    }
    meter.look(frame, n / RATE);
  }
  return meter;
}

/** One colour, then the other, this often a second. */
const blink = (one: Color, other: Color, frequency: number) => (seconds: number) =>
  (seconds * frequency) % 1 < 0.5 ? one : other;
const grey = (value: number): Color => [value, value, value];

test("a square that blinks five times a second is harmful", () => {
  expect(watch(0.5, blink(grey(255), grey(0), 5)).worst.general).toBeGreaterThan(0.4);
});

test("a square that blinks twice a second, or is small, is not", () => {
  expect(watch(0.5, blink(grey(255), grey(0), 2)).isHarmful).toBe(false);
  expect(watch(0.15, blink(grey(255), grey(0), 5)).isHarmful).toBe(false);
});

test("a slow fade is not, nor a fast tremble of less than a tenth", () => {
  expect(watch(1, (seconds) => grey(127 - 127 * Math.cos(Math.PI * seconds))).worst.general).toBe(
    0,
  );
  expect(watch(1, blink(grey(128), grey(140), 10)).worst.general).toBe(0);
});

test("a swing that takes several frames counts as one", () => {
  const swing = (seconds: number) => grey(127 + 127 * Math.sin(2 * Math.PI * 5 * seconds));
  expect(watch(0.5, swing).isHarmful).toBe(true);
});

test("bright light that stays above 0.8 may tremble", () => {
  expect(watch(1, blink(grey(255), grey(235), 10)).worst.general).toBe(0);
  expect(watch(1, blink(grey(255), grey(225), 10)).worst.general).toBeGreaterThan(0.8);
});

test("red that blinks is harmful by both definitions where its luminance would not be", () => {
  const { worst } = watch(1, blink([150, 0, 0], grey(0), 6));
  expect(worst.general).toBe(0);
  expect(worst.red).toBeGreaterThan(0.8);
  expect(worst.redChromatic).toBeGreaterThan(0.8);
});

test("dark red that blinks against black is so by the newer definition alone", () => {
  const { worst } = watch(1, blink([60, 0, 0], grey(0), 6));
  expect(worst.red).toBe(0);
  expect(worst.redChromatic).toBeGreaterThan(0.8);
});

test("gold that blinks faintly is not red", () => {
  const { worst } = watch(1, blink([120, 90, 40], [140, 105, 48], 6));
  expect(Math.max(worst.general, worst.red, worst.redChromatic)).toBe(0);
});
