/** Longest step, seconds: with hot air in every tick it takes some seconds of script. */
const LONGEST_STEP = 60;
/** A breath ten times as strong as one that puts the candle out is a storm. */
const STRONGEST_BREATH = 10;

/** A step's length, seconds; what is no length is none. */
export function lengthOfStep(seconds: unknown): number {
  if (typeof seconds !== "number" || !(seconds > 0)) return 0;
  if (seconds <= LONGEST_STEP) return seconds;
  throw new RangeError(
    `step() takes at most ${LONGEST_STEP} seconds at once, not ${seconds}. Take several steps, or reset().`,
  );
}

/** How strong a breath is, from what it is said to be. */
export function strengthOfBreath(strength: unknown): number {
  return Math.min(Math.max(Number(strength) || 0, 0), STRONGEST_BREATH);
}

/** A box of canvas pixels: whole ones, no larger than the picture, and at most its size beside it. */
export function boxWithin(
  picture: { readonly width: number; readonly height: number },
  [x, y, width, height]: readonly [unknown, unknown, unknown, unknown],
): [x: number, y: number, width: number, height: number] {
  const whole = (value: unknown, least: number, most: number) =>
    Math.min(Math.max(Math.floor(Number(value) || 0), least), most);
  return [
    whole(x, -picture.width, picture.width),
    whole(y, -picture.height, picture.height),
    whole(width, 0, picture.width),
    whole(height, 0, picture.height),
  ];
}
