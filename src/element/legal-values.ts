/** Longest step, seconds: simulating it with the plume takes seconds. */
const LONGEST_STEP = 60;
/** Strongest breath, where 1 puts out a candle at arm's length. */
const STRONGEST_BREATH = 10;

/** A step's length, seconds; 0 for illegal values. */
export function lengthOfStep(seconds: unknown): number {
  if (typeof seconds !== "number" || !(seconds > 0)) return 0;
  if (seconds <= LONGEST_STEP) return seconds;
  throw new RangeError(`step() takes at most ${LONGEST_STEP} seconds, not ${seconds}.`);
}

/** A breath's strength; 0 for illegal values. */
export function strengthOfBreath(strength: unknown): number {
  return Math.min(Math.max(Number(strength) || 0, 0), STRONGEST_BREATH);
}

/** A box of canvas pixels: whole ones, no larger than the canvas, and at most its size beside it. */
export function boxWithin(
  canvas: { readonly width: number; readonly height: number } | null,
  [x, y, width, height]: readonly [unknown, unknown, unknown, unknown],
): [x: number, y: number, width: number, height: number] {
  const { width: widest = 0, height: highest = 0 } = canvas ?? {};
  const whole = (value: unknown, least: number, most: number) =>
    Math.min(Math.max(Math.floor(Number(value) || 0), least), most);
  return [
    whole(x, -widest, widest),
    whole(y, -highest, highest),
    whole(width, 0, widest),
    whole(height, 0, highest),
  ];
}
