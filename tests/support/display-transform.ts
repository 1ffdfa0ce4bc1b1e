import { adaptation, adaptedWhite, luma, type Rgb, VIBRANCE } from "../../src/light/color.ts";
import { TAPER } from "../../src/light/flame-light.ts";
import { EXPOSURE_LAW } from "../../src/world/player/exposure-adaptation.ts";

/** What shaders/post/display.frag makes of light, without glare: the numbers of its includes. */
const METER = { columns: 32, rows: 18, taps: 4, darkest: 1e-4, surface: 3, flame: 6 };
const GRADE = { faint: 0.95, strong: 1.4, beyond: 0.8 };
const TONE = { contrast: 1.5, grey: 0.18, bleach: 0.053, mostBleach: 0.92, golden: [0.1, 0.45] };

const GAINS = adaptation(TAPER.color);
const WHITE = adaptedWhite();

/** Linear Rec. 709, cd/m², three numbers a pixel, rows from the top. */
export interface Picture {
  readonly width: number;
  readonly height: number;
  readonly radiance: ArrayLike<number>;
}

function smoothstep(low: number, high: number, x: number): number {
  const share = Math.min(Math.max((x - low) / (high - low), 0), 1);
  return share * share * (3 - 2 * share);
}

/** Factor by which the settled eye exposes a picture: shaders/post/meter.frag and exposure.frag. */
export function meteredExposure({ width, height, radiance }: Picture): number {
  const { columns, rows, taps, darkest, surface, flame } = METER;
  let sum = 0;
  let weights = 0;
  for (let row = 0; row < rows * taps; row++) {
    for (let column = 0; column < columns * taps; column++) {
      const x = Math.floor(((column + 0.5) / (columns * taps)) * width);
      const y = Math.floor(((row + 0.5) / (rows * taps)) * height);
      const brightness = Math.log2(Math.max(luma(colorOf(radiance, y * width + x)), darkest));
      const weight = 1 - smoothstep(surface, flame, brightness);
      sum += brightness * weight;
      weights += weight;
    }
  }
  const { luminance, stops, share, least, most } = EXPOSURE_LAW;
  const wanted = stops - share * (sum / Math.max(weights, 1e-3) - Math.log2(luminance));
  return 2 ** Math.min(Math.max(wanted, least), most);
}

/** A pixel of a picture. */
export function colorOf(radiance: ArrayLike<number>, pixel: number): Rgb {
  return [radiance[pixel * 3] ?? 0, radiance[pixel * 3 + 1] ?? 0, radiance[pixel * 3 + 2] ?? 0];
}

/** Linear colour of the screen, as shaders/lib/chromatic-adaptation.glsl and tone.glsl make it of exposed light. */
export function shown(light: Rgb): Rgb {
  return toned(graded(map(light, (x, i) => Math.max(x, 0) * (GAINS[i] ?? 1))));
}

function graded(light: Rgb): Rgb {
  const luminance = luma(light);
  if (luminance <= 0) return [0, 0, 0];
  const hue = map(light, (x, i) => Math.log(Math.max(x / luminance, 1e-4) / (WHITE[i] ?? 1)));
  const distance = Math.max(Math.hypot(...hue), 1e-4);
  let further = distance * (1 + VIBRANCE * Math.exp(-((distance / GRADE.faint) ** 2)));
  if (further > GRADE.strong) {
    further = GRADE.strong + GRADE.beyond * (1 - Math.exp((GRADE.strong - further) / GRADE.beyond));
  }
  const vivid = map(hue, (x, i) => (WHITE[i] ?? 1) * Math.exp(x * (further / distance)));
  const scale = luminance / luma(vivid);
  return map(vivid, (x) => x * scale);
}

function toned(color: Rgb): Rgb {
  const peak = Math.max(...color);
  if (peak <= 0) return [0, 0, 0];
  const hue = map(color, (x) => Math.max(x / peak, 1e-3));
  const level = TONE.grey * (peak / TONE.grey) ** TONE.contrast;
  const tone = level / (1 + level);
  const [low = 0, high = 1] = TONE.golden;
  const stops = Math.max(Math.log2(peak), 0);
  const bleach =
    Math.min((TONE.bleach * stops * stops) / (stops + 1), TONE.mostBleach) *
    smoothstep(low, high, Math.max(hue[1], hue[2]));
  return map(hue, (x, i) => x ** (1 - (i === 2 ? bleach * bleach : bleach)) * tone);
}

function map([r, g, b]: Rgb, how: (x: number, channel: number) => number): Rgb {
  return [how(r, 0), how(g, 1), how(b, 2)];
}
