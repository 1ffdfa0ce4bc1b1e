import { flameLight, TAPER } from "../../light/flame-light.js";
import type { World } from "../../world/world.js";

/** What of the chamberstick stands in its own light: heights above its foot and radii, metres. */
const CANDLE = { rim: 0.2015, rimRadius: 0.0105, pan: 0.018, panRadius: 0.066 } as const;

/** The flame as the shaders' `Light` block has it; a hidden candle stands in no light. */
export function lightBlock(world: World, showsCandle: boolean) {
  const { foot } = world.shown;
  const { position, halfHeight, intensity, radius } = flameLight(world, TAPER);
  return {
    position,
    halfHeight,
    intensity,
    radius,
    axis: [foot[0], foot[2]],
    rim: foot[1] + CANDLE.rim,
    rimRadius: showsCandle ? CANDLE.rimRadius : 0,
    pan: foot[1] + CANDLE.pan,
    panRadius: showsCandle ? CANDLE.panRadius : 0,
  };
}
