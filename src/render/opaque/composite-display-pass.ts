import compositeDisplayFrag from "../../../shaders/opaque/composite-display.frag";
import displayVert from "../../../shaders/post/display.vert";
import upscaleFrag from "../../../shaders/post/upscale.frag";
import type { Box, Gpu, Program, RenderTarget, Surface, Texture } from "../../gl/gpu.js";
import type { Steps } from "../../world/steps.js";
import { fittedTarget } from "../fitted-target.js";
import type { Size } from "../frame-input.js";
import { forEachGBufferKind, type GBufferKind } from "../gbuffer/gbuffer.js";
import { type DisplayLut, toneLut } from "../post/display-lut.js";
import type { DisplayTransform, DisplayUniforms } from "../post/display-pass.js";
import { boxesBeside, scaleBox } from "../screen-bounds.js";
import type { FrameBlocks, OpaqueLayer } from "./opaque-stage.js";
import { TemporalUpsampling } from "./temporal-upsampling.js";

export interface DisplayOptions {
  readonly uniforms: DisplayUniforms;
  readonly transform: DisplayTransform;
  /** Where the bloom is, in pixels of a canvas of `size`. */
  readonly bloomBounds: readonly Box[];
  readonly size: Size;
  readonly screen: Surface;
}

/**
 * Composite and display transform in one pass, by a tone LUT: albedo times lighting straight to the canvas.
 *
 * A reduced layer is composited at its own resolution and upsampled; of a reprojected one only the bloom's part is.
 */
export class CompositeDisplayPass {
  readonly #gpu: Gpu;
  /** Where the bloom is, and elsewhere; a reprojected layer has nothing else. */
  readonly #composite: Readonly<Record<GBufferKind, Program>>;
  readonly #withoutBloom: Readonly<Record<GBufferKind, Program | null>>;
  readonly #temporal: TemporalUpsampling;
  readonly #upscale: Program;
  readonly toneLut: DisplayLut;
  /** Only if the canvas is of another size. */
  #upscaled: RenderTarget | null = null;

  constructor(gpu: Gpu) {
    this.#gpu = gpu;
    const composite = (kind: Readonly<Record<string, number>>, BLOOM: 0 | 1) =>
      gpu.program("opaque/composite-display", displayVert, compositeDisplayFrag, {
        defines: { ...kind, BLOOM },
      });
    this.#composite = forEachGBufferKind((kind) => composite(kind, 1));
    this.#withoutBloom = forEachGBufferKind((kind) =>
      kind.REPROJECTED ? null : composite(kind, 0),
    );
    this.#temporal = new TemporalUpsampling(gpu);
    this.#upscale = gpu.pass("post/upscale", upscaleFrag);
    this.toneLut = toneLut(gpu);
  }

  /** @param textures of the layer, its G-buffer, the bloom, the exposure and the tone LUT */
  *render(
    layer: OpaqueLayer,
    textures: Readonly<Record<"uBloom" | "uExposure" | "uToneLut", Texture>>,
    options: DisplayOptions,
    blocks: FrameBlocks,
  ): Steps {
    const draw = {
      textures: { ...layer.textures, ...textures },
      uniforms: { ...layer.uniforms, ...options.uniforms },
      blocks: { ...blocks },
    };
    const composite = (target: Surface, size: Size): readonly Box[] => {
      const boxes = options.bloomBounds.map((box) => scaleBox(box, options.size, size));
      const { [layer.kind]: program } = this.#composite;
      for (const scissor of boxes) this.#gpu.draw({ ...draw, program, target, scissor });
      const { [layer.kind]: beside } = this.#withoutBloom;
      for (const scissor of beside ? boxesBeside(boxes, size) : []) {
        this.#gpu.draw({ ...draw, program: beside!, target, scissor });
      }
      return boxes;
    };
    if (layer.kind === "full") {
      this.#drawFull(composite, options);
      return;
    }
    const { screen, size } = options;
    yield* this.#temporal.show(layer, (target) => composite(target, target), screen, size);
  }

  /** Straight to the canvas, unless that is still of another size. */
  #drawFull(
    composite: (target: Surface, size: Size) => void,
    { size, screen }: DisplayOptions,
  ): void {
    const { canvas } = this.#gpu;
    if (canvas.width === size.width && canvas.height === size.height) {
      composite(screen, size);
      return;
    }
    const options = { label: "composite/upscaled", ...size, color: ["RGB8"] } as const;
    this.#upscaled = fittedTarget(this.#gpu, this.#upscaled, options);
    composite(this.#upscaled, size);
    const textures = { uSource: this.#upscaled.color };
    this.#gpu.draw({ program: this.#upscale, target: screen, textures });
  }
}
