import downFrag from "../../../shaders/post/bloom-down.frag";
import upFrag from "../../../shaders/post/bloom-up.frag";
import type { Box, Gpu, Program, RenderTarget, Texture, TextureFormat } from "../../gl/gpu.js";
import { expandBox, scaleBox } from "../screen-bounds.js";

/** Weight of the coarser levels against each level: the larger, the wider the bloom. */
const COARSER_WEIGHT = 0.7;

/**
 * Bloom: veiling glare of lens and eye, as a pyramid of ever wider blurs, mixed from the widest up.
 *
 * Each step conserves energy. Jimenez 2014, "Next Generation Post Processing in Call of Duty:
 * Advanced Warfare".
 */
export class BloomPass {
  readonly #gpu: Gpu;
  readonly #down: Program;
  readonly #up: Program;
  readonly #levels: number;
  readonly #format: TextureFormat;
  #pyramid: RenderTarget[] = [];

  constructor(
    gpu: Gpu,
    levels: number,
    { format, isFrugal }: { readonly format: TextureFormat; readonly isFrugal: boolean },
  ) {
    this.#format = format;
    this.#gpu = gpu;
    this.#levels = levels;
    this.#down = gpu.pass("post/bloom-down", downFrag);
    this.#up = gpu.pass("post/bloom-up", upFrag, {
      defines: { FRUGAL: isFrugal ? 1 : 0 },
    });
  }

  resize(width: number, height: number): void {
    for (const level of this.#pyramid) level.dispose();
    this.#pyramid = Array.from({ length: this.#levels }, (_, i) =>
      this.#gpu.renderTarget({
        label: `bloom/${i}`,
        // Half, rounded up: a texel of each level covers four of the finer one.
        width: Math.ceil(width / 2 ** (i + 1)),
        height: Math.ceil(height / 2 ** (i + 1)),
        color: [this.#format],
      }),
    );
  }

  /**
   * Radiance in, bloom out, at half the size.
   *
   * @param fullSize target for a bloom of the radiance's own size, which may hold the radiance: at low resolution,
   *   texels of half the size would be visible
   * @param region pixels of it that the bloom is wanted in: the rest is black. Default: all
   */
  render(
    radiance: Texture,
    fullSize: RenderTarget | null = null,
    region: Box | null = null,
  ): Texture {
    let source = radiance;
    const scissorOf = (target: RenderTarget) =>
      region && fullSize ? expandBox(scaleBox(region, fullSize, target), 1, target) : undefined;
    for (const target of this.#pyramid) {
      if (region) this.#gpu.clear(target, [0, 0, 0, 1]);
      this.#gpu.draw({
        program: this.#down,
        target,
        textures: { uSource: source },
        scissor: scissorOf(target),
      });
      source = target.color;
    }
    const finer = this.#pyramid.toReversed().slice(1);
    for (const target of fullSize ? [...finer, fullSize] : finer) {
      this.#gpu.draw({
        program: this.#up,
        target,
        textures: { uSource: source },
        uniforms: { uWeight: target === fullSize ? 1 : COARSER_WEIGHT },
        blend: "premultiplied",
        scissor: scissorOf(target),
      });
      source = target.color;
    }
    return source;
  }
}
