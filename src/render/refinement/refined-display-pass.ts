import displayVert from "../../../shaders/post/display.vert";
import fullscreenVert from "../../../shaders/post/fullscreen.vert";
import blendFrag from "../../../shaders/refinement/blend.frag";
import blendVert from "../../../shaders/refinement/blend.vert";
import displayFrag from "../../../shaders/refinement/display.frag";
import keepFrag from "../../../shaders/refinement/keep.frag";
import referenceFrag from "../../../shaders/refinement/reference.frag";
import type { Box, Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { RenderTarget } from "../../gl/render-target.js";
import type { Texture } from "../../gl/texture.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import { bandOf } from "../gbuffer/screen-bands.js";
import type { DisplayOptions } from "../opaque/composite-display-pass.js";
import type { FrameBlocks, OpaqueLayer } from "../opaque/opaque-stage.js";
import { whiteBalance } from "../post/display-pass.js";
import { ToneLut } from "../post/tone-lut.js";
import { expandBox } from "../screen-bounds.js";
import type { RefinedStage } from "./refined-stage.js";

/** Bands that a whole picture is kept in, and how many of them in a frame. */
const BANDS = 12;
const BANDS_PER_FRAME = 2;
/** The bloom of a full canvas reaches farther than that of a coarse one, pixels. */
const FARTHER = 96;

/**
 * Composite and display transform of a refined picture.
 *
 * Its surfaces change by their light alone, so their display colours are kept in a dimmer and in a brighter light,
 * and mixed: a third of what the tone LUT costs a CPU. Around the flame, whose glare comes on top, it is looked up.
 */
export class RefinedDisplayPass {
  readonly #gpu: Gpu;
  readonly #screen: VertexArray;
  readonly #stage: RefinedStage;
  readonly #toneLut: ToneLut;
  readonly #display: Program;
  readonly #blend: Program;
  readonly #keep: Program;
  readonly #setReference: Program;
  readonly #reference: RenderTarget;
  #kept: RenderTarget | null = null;
  /** What all of the kept colours depend on. */
  #key = "";
  /** Bands kept since that has changed. */
  #bands = 0;

  constructor(gpu: Gpu, screen: VertexArray, stage: RefinedStage) {
    this.#gpu = gpu;
    this.#screen = screen;
    this.#stage = stage;
    this.#toneLut = new ToneLut(gpu, screen);
    this.#display = gpu.program("refinement/display", displayVert, displayFrag);
    this.#blend = gpu.program("refinement/blend", blendVert, blendFrag);
    this.#keep = gpu.program("refinement/keep", fullscreenVert, keepFrag);
    this.#setReference = gpu.program("refinement/reference", fullscreenVert, referenceFrag);
    const texel = { width: 1, height: 1, color: ["RGBA16F"], filter: "nearest" } as const;
    this.#reference = gpu.renderTarget({ label: "refinement/reference", ...texel });
  }

  toneLut(transform: DisplayOptions["transform"]): Texture {
    return this.#toneLut.of(transform);
  }

  render(
    layer: OpaqueLayer,
    textures: Readonly<Record<"uBloom" | "uExposure" | "uToneLut", Texture>>,
    options: DisplayOptions,
    blocks: FrameBlocks,
  ): void {
    const { transform, size, autoExposure } = options;
    const pass = { vertexArray: this.#screen, blocks: { ...blocks } };
    const uAutoExposure = autoExposure ? 1 : 0;
    const key = JSON.stringify([transform, size, this.#stage.beginnings]);
    if (key !== this.#key) {
      this.#key = key;
      this.#bands = 0;
      this.#fit(size);
      const target = this.#reference;
      const uniforms = { uAutoExposure };
      this.#gpu.draw({ ...pass, program: this.#setReference, target, textures, uniforms });
    }
    const kept = this.#kept!;
    const [uDimmer, uBrighter] = kept.colors;
    const uReference = this.#reference.color;
    for (const scissor of this.#stale(kept)) {
      this.#gpu.draw({
        ...pass,
        program: this.#keep,
        target: kept,
        textures: { ...textures, uRadiance: layer.textures.uRadiance!, uReference },
        uniforms: { uWhiteBalance: whiteBalance(transform) },
        scissor,
      });
    }
    const isKept = this.#bands === BANDS;
    if (isKept) {
      this.#gpu.draw({
        ...pass,
        program: this.#blend,
        target: "canvas",
        textures: { ...textures, uDimmer: uDimmer!, uBrighter: uBrighter!, uReference },
        uniforms: { uAutoExposure },
      });
    }
    this.#gpu.draw({
      ...pass,
      program: this.#display,
      target: "canvas",
      textures: { ...layer.textures, ...textures },
      uniforms: {
        uWhiteBalance: whiteBalance(transform),
        uGlareShare: options.glareShare,
        uGlareOffset: options.bloomOffset,
        uAutoExposure,
      },
      scissor: isKept ? expandBox(options.bloomBounds, FARTHER, size) : undefined,
    });
  }

  /** Parts to be kept anew. */
  #stale(kept: RenderTarget): Box[] {
    const boxes = [...this.#stage.takeDrawn()];
    const end = Math.min(this.#bands + BANDS_PER_FRAME, BANDS);
    while (this.#bands < end) boxes.push(bandOf(kept, this.#bands++, BANDS));
    return boxes;
  }

  #fit({ width, height }: DisplayOptions["size"]): void {
    if (this.#kept?.width === width && this.#kept.height === height) return;
    this.#kept?.dispose();
    const color = ["RGBA8", "RGBA8"] as const;
    const options = { label: "refinement/kept", width, height, color, filter: "nearest" } as const;
    this.#kept = this.#gpu.renderTarget(options);
  }
}
