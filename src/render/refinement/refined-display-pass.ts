import exactFrag from "../../../shaders/post/display.frag";
import displayVert from "../../../shaders/post/display.vert";
import blendFrag from "../../../shaders/refinement/blend.frag";
import blendVert from "../../../shaders/refinement/blend.vert";
import displayFrag from "../../../shaders/refinement/display.frag";
import keepFrag from "../../../shaders/refinement/keep.frag";
import referenceFrag from "../../../shaders/refinement/reference.frag";
import type { Box, Gpu, Program, RenderTarget, Texture, TextureView } from "../../gl/gpu.js";
import type { Steps } from "../../world/steps.js";
import type { Size } from "../frame-input.js";
import type { DisplayOptions } from "../opaque/composite-display-pass.js";
import type { FrameBlocks, OpaqueLayer } from "../opaque/opaque-stage.js";
import { type DisplayLut, hueLut, toneLut } from "../post/display-lut.js";
import { whiteBalance } from "../post/display-pass.js";
import { bandOf, expandBox, expandBoxes } from "../screen-bounds.js";
import type { RefinedImage } from "./refined-fade.js";
import type { RefinedStage } from "./refined-stage.js";

/** Bands that a whole image is kept in, and how many of them in a frame. */
const BANDS = 12;
const BANDS_PER_FRAME = 2;
/** Faster than fetches where a CPU draws. */
const TEXEL_FOR_PIXEL = { uRadiance: "nearest", uDimmer: "nearest", uBrighter: "nearest" } as const;
/** The bloom of a full canvas reaches farther than that of a coarse one, pixels. */
const FARTHER = 24;
/** Beyond the frame, pixels. */
const OUTSIDE = 1e4;

/**
 * Composite and display transform of a refined image.
 *
 * Only the light of its surfaces changes, so their display colours are kept for a dimmer and for a brighter light,
 * and mixed: a third of the tone LUT's cost on a CPU. Around the flame, where glare is added, the LUT is used.
 */
export class RefinedDisplayPass {
  readonly #gpu: Gpu;
  readonly #stage: RefinedStage;
  readonly toneLut: DisplayLut;
  readonly #hueLut: DisplayLut;
  /** Without kept colours, and over them. */
  readonly #display: Program;
  readonly #glare: Program;
  readonly #exact: Program;
  readonly #blend: Program;
  readonly #keep: Program;
  readonly #setReference: Program;
  /** Of the dimmer light, and of the brighter one. */
  readonly #references: readonly RenderTarget[];
  #kept: RenderTarget | null = null;
  /** Each of the two kept textures. */
  #views: readonly TextureView[] = [];
  #depth: Texture | null = null;
  /** Key of everything that the kept colours depend on. */
  #key = "";
  /** Bands kept since that has changed. */
  #bands = 0;

  constructor(gpu: Gpu, stage: RefinedStage) {
    this.#gpu = gpu;
    this.#stage = stage;
    this.toneLut = toneLut(gpu);
    this.#hueLut = hueLut(gpu);
    const display = (KEPT: 0 | 1) =>
      gpu.program("refinement/display", blendVert, displayFrag, { defines: { KEPT } });
    this.#display = display(0);
    this.#glare = display(1);
    const defines = { TONE_LUT: 0 };
    this.#exact = gpu.program("post/display", displayVert, exactFrag, { defines });
    this.#blend = gpu.program("refinement/blend", blendVert, blendFrag);
    this.#keep = gpu.pass("refinement/keep", keepFrag);
    this.#setReference = gpu.pass("refinement/reference", referenceFrag);
    const texel = { width: 1, height: 1, color: ["RGBA16F"], filter: "nearest" } as const;
    this.#references = ["dimmer", "brighter"].map((name) =>
      gpu.renderTarget({ label: `refinement/${name} reference`, ...texel }),
    );
  }

  /** The last displayed image; null before all of it was kept. */
  image(): RefinedImage | null {
    const { source, flame } = this.#stage;
    const [uDimmer, uBrighter] = this.#kept?.colors ?? [];
    if (this.#bands < BANDS || !source || !uDimmer || !uBrighter || !this.#depth) return null;
    const uReference = this.#references[0]!.color;
    const textures = { uDimmer, uBrighter, uReference, uRefinedDepth: this.#depth };
    return {
      textures,
      source,
      flame,
      light: this.#stage.imageLight.isOfFlame ? null : this.#stage.imageLight.block,
    };
  }

  *render(
    layer: OpaqueLayer,
    textures: Readonly<Record<"uBloom" | "uExposure" | "uToneLut", Texture>>,
    options: DisplayOptions,
    blocks: FrameBlocks,
  ): Steps {
    const { transform, size } = options;
    const { uAutoExposure } = options.uniforms;
    this.#depth = layer.depth;
    const key = JSON.stringify([transform, size, this.#stage.images]);
    if (key !== this.#key) {
      this.#key = key;
      this.#bands = 0;
      this.#fit(size);
      for (const [uBrighter, target] of this.#references.entries()) {
        this.#gpu.draw({
          program: this.#setReference,
          target,
          textures,
          uniforms: { uAutoExposure, uBrighter },
          blocks: { Light: blocks.Light },
        });
      }
      yield;
      this.#hueLut(transform);
      yield;
      this.#keepTile([0, 0, 1, 1], { ...layer.textures, ...textures }, options, blocks); // to compile
      yield;
    }
    const all = { ...layer.textures, ...textures };
    this.#keepBands(all, options, blocks);
    yield;
    const isKept = this.#bands === BANDS;
    if (isKept) {
      for (const tile of this.#stage.takeDrawn()) this.#keepTile(tile, all, options, blocks);
    }
    const kept = isKept
      ? { uDimmer: this.#kept!.colors[0]!, uBrighter: this.#kept!.colors[1]! }
      : {};
    const pass = {
      target: options.screen,
      textures: { ...all, ...kept, uReference: this.#references[0]!.color },
      sampling: TEXEL_FOR_PIXEL,
      blocks: { ...blocks },
    };
    if (isKept) this.#gpu.draw({ ...pass, program: this.#blend, uniforms: { uAutoExposure } });
    const glaring = expandBoxes(options.bloomBounds, FARTHER, size);
    for (const scissor of isKept ? glaring : [undefined]) {
      this.#gpu.draw({
        ...pass,
        program: isKept ? this.#glare : this.#display,
        uniforms: {
          ...options.uniforms,
          ...(scissor && { uGlareBounds: glareBounds(scissor, size) }),
        },
        scissor,
      });
    }
  }

  /** Keeps a new tile, antialiased and by the exact display transform, as `high` displays it. */
  #keepTile(
    tile: Box,
    textures: Readonly<Record<string, Texture>>,
    { transform, size }: DisplayOptions,
    { Frame }: FrameBlocks,
  ): void {
    for (const [i, target] of this.#views.entries()) {
      this.#gpu.draw({
        program: this.#exact,
        target,
        textures: {
          ...textures,
          uExposure: this.#references[i]!.color,
          uHueLut: this.#hueLut(transform),
        },
        uniforms: {
          ...transform,
          uWhiteBalance: this.#white(transform),
          uAutoExposure: 1,
          uBloomTransform: [1, 1, 0, 0],
          uGlareShare: 0,
        },
        blocks: { Frame },
        // Antialiasing reads the pixels around.
        scissor: expandBox(tile, 1, size),
      });
    }
  }

  /** Keeps the image that the refinement has begun with, a few bands in a frame. */
  #keepBands(
    textures: Readonly<Record<string, Texture>>,
    { transform }: DisplayOptions,
    { Frame }: FrameBlocks,
  ): void {
    const end = Math.min(this.#bands + BANDS_PER_FRAME, BANDS);
    while (this.#bands < end) {
      const target = this.#kept!;
      this.#gpu.draw({
        program: this.#keep,
        target,
        textures: { ...textures, uReference: this.#references[0]!.color },
        uniforms: { uWhiteBalance: this.#white(transform) },
        blocks: { Frame },
        scissor: bandOf(target, this.#bands++, BANDS),
      });
    }
  }

  #white(transform: DisplayOptions["transform"]): readonly number[] {
    return whiteBalance(transform).map((gain, i) => gain * this.#stage.imageLight.flameColor[i]!);
  }

  #fit({ width, height }: DisplayOptions["size"]): void {
    if (this.#kept?.width === width && this.#kept.height === height) return;
    for (const old of [...this.#views, this.#kept]) old?.dispose();
    const color = ["RGBA8", "RGBA8"] as const;
    this.#kept = this.#gpu.renderTarget({ label: "refinement/kept", width, height, color });
    this.#views = this.#kept.colors.map((texture) =>
      this.#gpu.textureView({ label: "refinement/kept", textures: [texture] }),
    );
  }
}

/** Edges of a box: left, bottom, right, top. One at the frame's edge lies far outside. */
function glareBounds([x, y, wide, high]: Box, { width, height }: Size): number[] {
  return [
    x > 0 ? x : -OUTSIDE,
    y > 0 ? y : -OUTSIDE,
    x + wide < width ? x + wide : width + OUTSIDE,
    y + high < height ? y + high : height + OUTSIDE,
  ];
}
