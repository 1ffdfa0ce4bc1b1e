import type { Vec3 } from "../../world/geometry.js";
import type { FrameInput } from "../frame-input.js";
import { SCHEDULE } from "../schedule.js";
import { middleOfStillFlame } from "../standing-candle-captures.js";

/** Distance of a place that stands for the moon, metres. */
const MOON_DISTANCE = 1e6;

/**
 * Where normal-map shading takes the light to be, metres: at the carried flame; where that is out, at the nearest standing
 * one, or else towards the moon. In steps, so that small moves do not change the G-buffer.
 *
 * @param moonDirection in which the moon's light goes; null where it does not shine
 */
export function shadingOrigin(
  { world, captureLight }: Pick<FrameInput, "world" | "captureLight">,
  moonDirection: Readonly<Vec3> | null,
): Vec3 {
  const { flame, standing, interpolated } = world;
  if (flame.glow > 0) return inSteps(captureLight.position);
  let nearest = Infinity;
  let place: Vec3 | null = null;
  for (const candle of standing) {
    const [x, y, z] = candle.root;
    const [ex, ey, ez] = interpolated.eye;
    const distance = Math.hypot(x - ex, y - ey, z - ez);
    if (candle.flame.glow === 0 || distance >= nearest) continue;
    nearest = distance;
    place = middleOfStillFlame(candle);
  }
  if (place) return inSteps(place);
  if (!moonDirection) return inSteps(captureLight.position);
  const [x, y, z] = inSteps(moonDirection);
  return [-x * MOON_DISTANCE, -y * MOON_DISTANCE, -z * MOON_DISTANCE];
}

function inSteps([x, y, z]: Readonly<Vec3>): Vec3 {
  const step = SCHEDULE.normalMapShading;
  return [Math.round(x / step) * step, Math.round(y / step) * step, Math.round(z / step) * step];
}
