import displayFrag from "../../../shaders/candle/custom-display.frag";
import type { Gpu, Program } from "../../gl/gpu.js";
import type { RootedFlame } from "../../light/flame-light.js";
import type { Size } from "../frame-input.js";
import { CachedSurfaces, type DrawInLight } from "./cached-surfaces.js";
import { LightGroups } from "./light-groups.js";

/** Opaque surfaces of a model as a sum of images that are kept, one for each light. */
export class SummedSurfaces {
  readonly groups: LightGroups;
  /** Of the display: the sum is behind what is drawn in a frame. */
  readonly program: Program;
  readonly #cached: CachedSurfaces;
  /** Those that the images are of. */
  #flames: readonly (readonly number[])[] = [];

  constructor(gpu: Gpu, flames: number, draw: DrawInLight) {
    this.groups = new LightGroups(flames);
    const { count } = this.groups;
    this.#cached = new CachedSurfaces(gpu, draw);
    this.program = gpu.pass("candle/custom-display", displayFrag, { defines: { LIGHTS: count } });
  }

  /** Whether there are images to show. */
  get areShown(): boolean {
    return this.#cached.images.length > 0;
  }

  /** Of `program`. */
  get textures() {
    return Object.fromEntries(this.#cached.images.map((image, i) => [`uLight${i}`, image]));
  }

  /** Of `program`: factors on the images. Lights of luminance 1 are the studio and the bounce. */
  scales(rooted: readonly RootedFlame[], light: Parameters<LightGroups["scales"]>[2]) {
    return this.groups.scales(rooted, this.#flames, light);
  }

  /**
   * Continues the images of a size. True when none is missing.
   *
   * @param detail all that they depend on, beside the flames
   */
  proceed(size: Size, rooted: readonly RootedFlame[], detail: readonly boolean[]): boolean {
    const flames = this.groups.flamesOf(rooted);
    const details = flames.map((group) => [
      detail,
      group.map((one) => [one, rooted[one]!.flame.wick]),
    ]);
    const areDrawn = this.#cached.proceed(size, details);
    if (areDrawn) this.#flames = flames;
    return areDrawn;
  }

  /** Frees the images; others may follow. */
  dispose(): void {
    this.#cached.dispose();
  }
}
