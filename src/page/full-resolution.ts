import type { CandleFlameElement } from "../candle-flame-element.js";
import { isWalking } from "./walking.js";

/** How long a photo waits at most, milliseconds: without a GPU an image is refined some 4 s after a walk. */
const LONGEST = 8_000;
/** Time between two looks at the canvas, milliseconds. */
const INTERVAL = 200;

/**
 * Waits until `auto` draws at the canvas's full resolution, which it does without a GPU once the visitor stands; not for
 * long, since some machines never do.
 *
 * @param onWait called if there is something to wait for
 */
export async function fullResolution(room: CandleFlameElement, onWait: () => void): Promise<void> {
  const { clientWidth, maxPixelRatio } = room;
  const width = clientWidth * Math.min(devicePixelRatio, maxPixelRatio);
  const isCoarse = () =>
    room.quality === "auto" &&
    room.inspect === "picture" &&
    !room.paused &&
    !isWalking(room) &&
    room.stats.width < width - 1;
  if (isCoarse()) onWait();
  for (let waited = 0; isCoarse() && waited < LONGEST; waited += INTERVAL) {
    await new Promise((resolve) => setTimeout(resolve, INTERVAL));
  }
}
