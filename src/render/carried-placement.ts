import type { World } from "../world/world.js";
import type { Placement } from "./frame-input.js";
import { HANDLE_TURN } from "./volumetric/flame-pass.js";

/** Foot of the flame in the model's frame, metres: its node `flame`. */
const WICK = { x: 0.0011, z: 0.0003 } as const;

/** Where the carried candle is drawn: its wick is below the flame, whose place does not turn with the model. */
export function carriedPlacement({ candle, interpolated }: World): Placement {
  const { foot, flame } = interpolated;
  const yaw = candle.yaw + HANDLE_TURN;
  const [sin, cos] = [Math.sin(yaw), Math.cos(yaw)];
  const x = flame[0] - (cos * WICK.x + sin * WICK.z);
  return [x, foot[1], flame[2] - (cos * WICK.z - sin * WICK.x), yaw];
}
