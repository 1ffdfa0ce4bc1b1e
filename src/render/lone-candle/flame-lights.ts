import type { mat4 } from "gl-matrix";
import { emberRadiance, flameLight, type RootedFlame, TAPER } from "../../light/flame-light.js";
import { glareOf } from "./glare.js";

/** Most flames of the shaders' `Flames` block. */
export const MOST_FLAMES = 16;

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

  /**
   * @param clip clip space from world space
   * @param hasShadows whether the shadow atlas has a tile for each
   * @param glare factor on the light that the eye scatters
   */
  members(
    flames: readonly RootedFlame[],
    clip: mat4,
    hasShadows: boolean,
    glare: number,
  ): Record<string, Float32Array | number> {
    const all = this.#members;
    for (const [i, rooted] of flames.entries()) {
      const at = i * 4;
      const light = flameLight(rooted, TAPER);
      const { position, axis, halfHeight, radius, intensity } = light;
      all["centres[0]"].set([...position, halfHeight], at);
      all["alongs[0]"].set([...axis, radius], at);
      all["intensities[0]"].set([...intensity, hasShadows ? i : -1], at);
      all["roots[0]"].set(rooted.root, at);
      all["embers[0]"].set(emberRadiance(rooted.flame.ember), at);
      all["glares[0]"].set(glareOf(light, clip, glare), at);
    }
    return { ...all, count: flames.length };
  }
}
