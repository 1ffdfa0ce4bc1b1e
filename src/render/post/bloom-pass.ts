import downFrag from "../../../shaders/post/bloom-down.frag";
import upFrag from "../../../shaders/post/bloom-up.frag";
import fullscreenVert from "../../../shaders/post/fullscreen.vert";
import type { Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { RenderTarget } from "../../gl/render-target.js";
import type { Texture, TextureFormat } from "../../gl/texture.js";
import type { VertexArray } from "../../gl/vertex-array.js";

interface Size {
  readonly width: number;
  readonly height: number;
}

/** How much of each level comes from the wider ones below it: the larger, the wider the halo. */
const WIDER_SHARE = 0.7;

/**
 * Light scattered inside the lens and the eye: a pyramid of ever wider blurs, mixed from the widest up.
 *
 * Each step keeps the sum of light. Jimenez 2014, "Next Generation Post Processing in Call of Duty:
 * Advanced Warfare".
 */
export class BloomPass {
  readonly #gpu: Gpu;
  readonly #down: Program;
  readonly #up: Program;
  readonly #screen: VertexArray;
  readonly #levels: number;
  readonly #format: TextureFormat;
  #pyramid: RenderTarget[] = [];

  /** @param how of what each level is, and whether taps are dear */
  constructor(
    gpu: Gpu,
    screen: VertexArray,
    levels: number,
    how: { readonly format: TextureFormat; readonly isFrugal: boolean },
  ) {
    this.#format = how.format;
    this.#gpu = gpu;
    this.#screen = screen;
    this.#levels = levels;
    this.#down = gpu.program("post/bloom-down", fullscreenVert, downFrag);
    this.#up = gpu.program("post/bloom-up", fullscreenVert, upFrag, {
      defines: { FRUGAL: how.isFrugal ? 1 : 0 },
    });
  }

  resize(width: number, height: number): void {
    for (const level of this.#pyramid) level.dispose();
    this.#pyramid = Array.from({ length: this.#levels }, (_, i) =>
      this.#gpu.renderTarget({
        label: `bloom/${i}`,
        // Half, rounded up: a texel of each level covers four of the one before.
        width: Math.ceil(width / 2 ** (i + 1)),
        height: Math.ceil(height / 2 ** (i + 1)),
        color: [this.#format],
      }),
    );
  }

  /**
   * Radiance in, scattered radiance out, at half the size or where it is to be.
   *
   * @param onto of the radiance's own size, and may hold it: half of a picture that is coarse has texels that show
   */
  render(radiance: Texture, onto: RenderTarget | null = null): Texture {
    let source = radiance;
    for (const target of this.#pyramid) {
      this.#gpu.draw({
        program: this.#down,
        target,
        vertexArray: this.#screen,
        textures: { uSource: source },
      });
      source = target.color;
    }
    const finer = this.#pyramid.toReversed().slice(1);
    for (const target of onto ? [...finer, onto] : finer) {
      this.#gpu.draw({
        program: this.#up,
        target,
        vertexArray: this.#screen,
        textures: { uSource: source },
        uniforms: { uShare: target === onto ? 1 : WIDER_SHARE },
        blend: "premultiplied",
      });
      source = target.color;
    }
    return source;
  }
}

/** Share of a bloom of half the size, rounded up, that the picture fills. */
export function shareOf(picture: Size, bloom: Size): readonly [number, number] {
  return [picture.width / (2 * bloom.width), picture.height / (2 * bloom.height)];
}
