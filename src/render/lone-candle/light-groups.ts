import { flameLight, type RootedFlame, TAPER } from "../../light/flame-light.js";
import type { Vec3 } from "../../world/geometry.js";

/** Lights of the surfaces that images are kept of: the studio, the bounce, then groups of flames. */
export const [STUDIO_LIGHT, BOUNCE_LIGHT, FIRST_FLAMES] = [0, 1, 2] as const;
/** Most of them. */
const MOST_LIGHTS = 8;

/**
 * A model's lights as images are kept of them. Of up to six flames each has its own; of more, those of a group have one
 * together, as those that glow.
 */
export class LightGroups {
  /** How many lights there are. */
  readonly count: number;
  readonly #groups: readonly (readonly number[])[];
  readonly #scales: Float32Array;

  constructor(flames: number) {
    const groups = Math.min(flames, MOST_LIGHTS - FIRST_FLAMES);
    const all = [...Array(flames).keys()];
    this.#groups = [...Array(groups).keys()].map((group) =>
      all.filter((i) => i % groups === group),
    );
    this.count = FIRST_FLAMES + groups;
    this.#scales = new Float32Array(3 * this.count);
  }

  /** Flames that an image is of, by light: a single one is in its own, glowing or not. */
  flamesOf(rooted: readonly RootedFlame[]): readonly (readonly number[])[] {
    const glowing = this.#groups.map((group) =>
      group.length > 1 ? group.filter((one) => rooted[one]!.flame.glow > 0) : group,
    );
    return [[], [], ...glowing];
  }

  /**
   * Factors on the images, which are of flames of 1 cd and of lights of luminance 1, by light and channel.
   *
   * @param flames that the images are of
   * @param lights luminance of the studio and of the bounce, and the factor on embers
   */
  scales(
    rooted: readonly RootedFlame[],
    flames: readonly (readonly number[])[],
    { studio, bounce, ember }: Readonly<Record<"studio" | "bounce" | "ember", number>>,
  ): Float32Array {
    this.#set(STUDIO_LIGHT, [studio, studio, studio]);
    this.#set(BOUNCE_LIGHT, [bounce, bounce, bounce]);
    for (const [i, group] of this.#groups.entries()) {
      const light = FIRST_FLAMES + i;
      const all = group.map((one) => tapersOf(rooted[one]!, ember));
      const share = 1 / Math.max(flames[light]?.length ?? 0, 1);
      const sum = (channel: 0 | 1 | 2) => all.reduce((sum, one) => sum + one[channel], 0) * share;
      this.#set(light, [sum(0), sum(1), sum(2)]);
    }
    return this.#scales;
  }

  #set(light: number, scale: Vec3): void {
    this.#scales.set(scale, 3 * light);
  }
}

/** Light of a flame as a multiple of a taper's, by channel. */
function tapersOf(rooted: RootedFlame, emberFactor: number): Vec3 {
  const { intensity } = flameLight(rooted, TAPER, emberFactor);
  const { color } = TAPER;
  return [intensity[0] / color[0], intensity[1] / color[1], intensity[2] / color[2]];
}
