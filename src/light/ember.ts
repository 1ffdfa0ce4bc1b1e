import type { Vec3 } from "../world/bounds.js";
import type { World } from "../world/world.js";
import { sootRadiance } from "./soot.js";

/** The glowing end of a wick whose flame is out, as a light. */
export interface Ember {
  /** Metres. */
  readonly position: Vec3;
  /** Candela, linear Rec. 709 whose luma is the luminous intensity. */
  readonly intensity: Vec3;
}

/** What of the wick's end glows, as seen from a side, m². */
const AREA = 5e-6;
/** The end of the wick, above the foot of the flame. Metres. */
const HEIGHT = 0.004;
/** Colder than this nothing glows that anyone sees, kelvin (Draper 1847). */
const DARK = 798;

export function ember({ shown, flame }: World): Ember {
  const [x, y, z] = shown.flame;
  const glow = sootRadiance(flame.ember);
  // The table of soot ends at 1000 K; below, light goes as Wien's law at 600 nm has it.
  const fainter = flame.ember < 1000 ? Math.exp(23980 * (1 / 1000 - 1 / flame.ember)) : 1;
  const share = flame.isLit || flame.ember < DARK ? 0 : AREA * fainter;
  return {
    position: [x, y + HEIGHT, z],
    intensity: [glow[0] * share, glow[1] * share, glow[2] * share],
  };
}
