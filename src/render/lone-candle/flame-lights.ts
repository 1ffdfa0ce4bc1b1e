import type { mat4 } from "gl-matrix";
import {
  emberRadiance,
  type FlameLight,
  flameLight,
  type RootedFlame,
  TAPER,
} from "../../light/flame-light.js";
import { flameRadius, fullHeight, heightInTapers } from "../../world/flame/burning.js";
import type { Flame } from "../../world/flame/flame.js";
import type { Vec3 } from "../../world/geometry.js";
import type { WickShape } from "../volumetric/wick-shape.js";
import { glareOf } from "./glare.js";

/** Most flames of the shaders' `Flames` block. */
export const MOST_FLAMES = 16;

/** Half height of a flame's light as a capsule, as a share of its height. */
const HALF_HEIGHT = 0.36;

/** A taper's middle above its root, metres. */
const MIDDLE = 0.016;
const shadowHeight = ({ wick }: Flame) => MIDDLE * heightInTapers(wick);

/** Capture origin of a flame's shadow cube: its middle at rest, metres. */
export const shadowOrigin = ({ root: [x, y, z], flame }: RootedFlame): Vec3 => [
  x,
  y + shadowHeight(flame),
  z,
];

const vectors = () => new Float32Array(MOST_FLAMES * 4);

/** Members of the shaders' `Flames` block. */
export class FlameLights {
  readonly #members = {
    "centres[0]": vectors(),
    "alongs[0]": vectors(),
    "intensities[0]": vectors(),
    "roots[0]": vectors(),
    "embers[0]": vectors(),
    "glares[0]": vectors(),
  };
  readonly wicks: readonly WickShape[];

  /** @param wicks needed where they are drawn */
  constructor(wicks: readonly WickShape[] = []) {
    this.wicks = wicks;
  }

  /**
   * @param clip clip space from world space
   * @param hasShadows whether each has a shadow cube
   * @param glare factor on the light that the eye scatters
   * @param emberFactor on embers and their light
   */
  members(
    flames: readonly RootedFlame[],
    clip: mat4,
    hasShadows: boolean,
    glare: number,
    emberFactor = 1,
  ) {
    const all = this.#members;
    for (const [i, rooted] of flames.entries()) {
      const at = i * 4;
      const light = flameLight(rooted, TAPER, emberFactor);
      this.#setLight(i, rooted, light, hasShadows ? i : -1);
      all["embers[0]"].set(emberRadiance(rooted.flame.ember, emberFactor), at);
      all["embers[0]"][at + 3] = this.wicks[i]?.end ?? 0;
      all["glares[0]"].set(glareOf(light, clip, glare), at);
    }
    return { ...all, count: flames.length };
  }

  /**
   * The same of some flames alone, each upright and of 1 cd: for light that is kept.
   *
   * @param places of them in the list of all, and of their shadow cubes
   */
  atRest(
    flames: readonly RootedFlame[],
    places: readonly number[],
    hasShadows: boolean,
  ): Record<string, Float32Array | number> {
    for (const [i, place] of places.entries()) {
      const rooted = flames[place]!;
      this.#setLight(i, rooted, lightAtRest(rooted), hasShadows ? place : -1);
    }
    return { ...this.#members, count: places.length };
  }

  #setLight(i: number, { root, flame }: RootedFlame, light: FlameLight, slot: number): void {
    const { position, axis, halfHeight, radius, intensity } = light;
    const all = this.#members;
    const at = i * 4;
    all["centres[0]"].set([...position, halfHeight], at);
    all["alongs[0]"].set([...axis, radius], at);
    all["intensities[0]"].set([...intensity, slot], at);
    all["roots[0]"].set([...root, shadowHeight(flame)], at);
  }
}

/** A flame on its wick in still air, of 1 cd. */
function lightAtRest({ root, flame }: RootedFlame): FlameLight {
  const height = fullHeight(flame.wick);
  const [x, y, z] = root;
  return {
    position: [x, y + (height / TAPER.height) * TAPER.centre, z],
    axis: [0, 1, 0],
    halfHeight: HALF_HEIGHT * height,
    radius: 0.8 * flameRadius(flame.wick, 1),
    intensity: [...TAPER.color],
  };
}
