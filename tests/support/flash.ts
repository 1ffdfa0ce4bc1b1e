/**
 * Counts flashes as WCAG 2.2's success criterion 2.3.1, "Three Flashes or Below Threshold", defines them.
 *
 * - General flash: a pair of opposing changes of relative luminance by 0.1 or more, the darker below 0.8.
 * - Red flash, older working definition: a pair of opposing changes of max(0, R - G - B) x 320 by more
 *   than 20, where either state is saturated red, R / (R + G + B) >= 0.8.
 * - Red flash of WCAG 2.2 and ISO 9241-391: a pair of opposing changes by more than 0.2 in CIE 1976 u'v',
 *   where either state is saturated red.
 *
 * R, G and B are linear. Harmful is more than three flashes in a second over more than a quarter of any
 * 10-degree field: 341 x 256 of 1024 x 768 pixels. Stricter than the text: pixels need not
 * flash in step to be counted together, one that was red once is taken for red, and the seventh change
 * in a second already is one too many.
 * A smaller picture is judged by the same shares of its size; it must be averaged down, not sampled.
 */
export class FlashMeter {
  /** Largest share of any field that has flashed more than three times in a second; harmful above 1/4. */
  readonly worst = { general: 0, red: 0, redChromatic: 0 };
  /** Frames in which a pixel had another colour than before. */
  moving = 0;
  readonly #width: number;
  readonly #height: number;
  readonly #general: Reversals;
  readonly #red: Reversals;
  readonly #chromatic: Reversals;
  /** u', v' and saturation of the state that a pixel last changed to. */
  readonly #anchor: Float32Array;
  /** Colours that were looked at last: a pixel that keeps its own changes nothing. */
  readonly #last: Float32Array;
  #isFirst = true;

  constructor(width: number, height: number) {
    this.#width = width;
    this.#height = height;
    const pixels = width * height;
    this.#general = new Reversals(pixels);
    this.#red = new Reversals(pixels);
    this.#chromatic = new Reversals(pixels);
    this.#anchor = new Float32Array(pixels * 3);
    this.#last = new Float32Array(pixels * 3).fill(Number.NaN);
  }

  /** Looks at the next frame: 8-bit sRGB with alpha, shown at this time in seconds. */
  look(rgba: ArrayLike<number>, seconds: number): void {
    const last = this.#last;
    let isSameFrame = true;
    for (let i = 0; i < this.#width * this.#height; i++) {
      const isSame =
        rgba[i * 4] === last[i * 3] &&
        rgba[i * 4 + 1] === last[i * 3 + 1] &&
        rgba[i * 4 + 2] === last[i * 3 + 2];
      if (isSame) continue;
      isSameFrame = false;
      for (let channel = 0; channel < 3; channel++) {
        last[i * 3 + channel] = rgba[i * 4 + channel] ?? 0;
      }
      const red = linear(rgba[i * 4]);
      const green = linear(rgba[i * 4 + 1]);
      const blue = linear(rgba[i * 4 + 2]);
      const luminance = 0.2126 * red + 0.7152 * green + 0.0722 * blue;
      // Just short of a tenth, so that rounding lets nothing by.
      this.#general.follow(i, luminance, 0.1 - 1e-6, (darker) => darker < 0.8, seconds);
      const sum = red + green + blue;
      const isRed = sum > 0 && red / sum >= 0.8;
      this.#red.note(i, isRed);
      const excess = Math.max(0, red - green - blue) * 320;
      this.#red.follow(i, excess, 20 + 1e-6, () => this.#red.wasNoted(i), seconds);
      this.#shift(i, red, green, blue, isRed, seconds);
    }
    if (!this.#isFirst && !isSameFrame) this.moving++;
    this.#isFirst = false;
    const { worst } = this;
    worst.general = Math.max(worst.general, this.#share(this.#general, seconds));
    worst.red = Math.max(worst.red, this.#share(this.#red, seconds));
    worst.redChromatic = Math.max(worst.redChromatic, this.#share(this.#chromatic, seconds));
  }

  get isHarmful(): boolean {
    return Math.max(...Object.values(this.worst)) > 0.25;
  }

  #shift(i: number, red: number, green: number, blue: number, isRed: boolean, time: number): void {
    const x = 0.4124 * red + 0.3576 * green + 0.1805 * blue;
    const y = 0.2126 * red + 0.7152 * green + 0.0722 * blue;
    const z = 0.0193 * red + 0.1192 * green + 0.9505 * blue;
    const sum = x + 15 * y + 3 * z;
    // Black has no hue: the screen's white stands in for it.
    const u = sum > 0 ? (4 * x) / sum : 0.1978;
    const v = sum > 0 ? (9 * y) / sum : 0.4683;
    const anchor = this.#anchor;
    const away = Math.sqrt((u - (anchor[i * 3] ?? 0)) ** 2 + (v - (anchor[i * 3 + 1] ?? 0)) ** 2);
    const wasRed = anchor[i * 3 + 2] === 1;
    const changes = away > 0.2 && (isRed || wasRed);
    if (changes && !this.#isFirst) this.#chromatic.record(i, time);
    if (changes || this.#isFirst) {
      anchor[i * 3] = u;
      anchor[i * 3 + 1] = v;
      anchor[i * 3 + 2] = isRed ? 1 : 0;
    }
  }

  /** Largest share of a field that is flashing, by sums over rectangles. */
  #share(reversals: Reversals, seconds: number): number {
    if (!reversals.hasFlashed) return 0;
    const [width, height] = [this.#width, this.#height];
    const across = Math.max(1, Math.round((width * 341) / 1024));
    const down = Math.max(1, Math.round((height * 256) / 768));
    const stride = width + 1;
    const sums = new Int32Array(stride * (height + 1));
    const sum = (x: number, y: number) => sums[y * stride + x] ?? 0;
    let most = 0;
    for (let y = 1; y <= height; y++) {
      for (let x = 1; x <= width; x++) {
        const flashes = reversals.isFlashing((y - 1) * width + x - 1, seconds) ? 1 : 0;
        sums[y * stride + x] = flashes + sum(x - 1, y) + sum(x, y - 1) - sum(x - 1, y - 1);
        const [left, top] = [Math.max(0, x - across), Math.max(0, y - down)];
        most = Math.max(most, sum(x, y) - sum(left, y) - sum(x, top) + sum(left, top));
      }
    }
    return most / (across * down);
  }
}

/** Changes in a second that are more than three flashes, which are pairs of them. */
const TOO_MANY = 7;

/** When each pixel's value last turned by more than a threshold. */
class Reversals {
  readonly #high: Float32Array;
  readonly #low: Float32Array;
  readonly #way: Int8Array;
  readonly #noted: Uint8Array;
  readonly #times: Float64Array;
  readonly #count: Uint16Array;
  /** Whether any pixel has ever turned often enough. */
  hasFlashed = false;

  constructor(pixels: number) {
    this.#high = new Float32Array(pixels).fill(Number.NEGATIVE_INFINITY);
    this.#low = new Float32Array(pixels).fill(Number.POSITIVE_INFINITY);
    this.#way = new Int8Array(pixels);
    this.#noted = new Uint8Array(pixels);
    this.#times = new Float64Array(pixels * TOO_MANY).fill(Number.NEGATIVE_INFINITY);
    this.#count = new Uint16Array(pixels);
  }

  /** Remembers that a pixel was once in a state: from then on all of its turns may count. */
  note(i: number, isIn: boolean): void {
    if (isIn) this.#noted[i] = 1;
  }

  wasNoted(i: number): boolean {
    return this.#noted[i] === 1;
  }

  follow(
    i: number,
    value: number,
    least: number,
    counts: (lower: number) => boolean,
    seconds: number,
  ): void {
    const high = Math.max(this.#high[i] ?? value, value);
    const low = Math.min(this.#low[i] ?? value, value);
    const way = this.#way[i] ?? 0;
    this.#high[i] = high;
    this.#low[i] = low;
    const rises = way <= 0 && value - low >= least && counts(low);
    const falls = way >= 0 && high - value >= least && counts(value);
    if (!rises && !falls) return;
    this.#way[i] = rises ? 1 : -1;
    this.#high[i] = value;
    this.#low[i] = value;
    this.record(i, seconds);
  }

  record(i: number, seconds: number): void {
    const count = this.#count[i] ?? 0;
    this.#times[i * TOO_MANY + (count % TOO_MANY)] = seconds;
    this.#count[i] = count + 1;
    if (count + 1 >= TOO_MANY) this.hasFlashed = true;
  }

  isFlashing(i: number, seconds: number): boolean {
    const oldest = this.#times[i * TOO_MANY + ((this.#count[i] ?? 0) % TOO_MANY)] ?? 0;
    return seconds - oldest <= 1;
  }
}

/** Of each byte: pictures are of whole ones. */
const LINEAR = Float64Array.from({ length: 256 }, (_, byte) => decode(byte));

function linear(byte = 0): number {
  return LINEAR[byte] ?? decode(byte);
}

/** Light of a channel as it is on the screen, from 0 to 255: IEC 61966-2-1. */
export function decode(byte: number): number {
  const value = byte / 255;
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
}
