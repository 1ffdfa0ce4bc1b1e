import type { World } from "../world/world.js";
import type { Placement } from "./frame-input.js";
import { HANDLE_TURN } from "./volumetric/flame-pass.js";

/** Where the carried candle is drawn: its wick is below the flame, whose place does not turn with the model. */
export function carriedPlacement({ interpolated, setup }: World): Placement {
  const { foot, flame, candleYaw } = interpolated;
  const yaw = candleYaw + HANDLE_TURN;
  const [sin, cos] = [Math.sin(yaw), Math.cos(yaw)];
  const [wickX, , wickZ] = setup.wick;
  const x = flame[0] - (cos * wickX + sin * wickZ);
  return [x, foot[1], flame[2] - (cos * wickZ - sin * wickX), yaw];
}
