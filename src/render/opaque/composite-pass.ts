import showFrag from "../../../shaders/opaque/composite-display.frag";
import againFrag from "../../../shaders/opaque/reproject-color.frag";
import displayVert from "../../../shaders/post/display.vert";
import fullscreenVert from "../../../shaders/post/fullscreen.vert";
import smoothFrag from "../../../shaders/post/fxaa.frag";
import tableFrag from "../../../shaders/post/tone-lut.frag";
import enlargeFrag from "../../../shaders/post/upscale.frag";
import type { Box, Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { RenderTarget } from "../../gl/render-target.js";
import type { Texture } from "../../gl/texture.js";
import type { UniformBlock } from "../../gl/uniform-block.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import { forEachGBufferKind, type GBufferKind } from "../gbuffer/gbuffer.js";
import type { DisplayTransform } from "../post/display-pass.js";
import { scaleBox } from "../screen-bounds.js";
import type { Lit } from "./lighting-pass.js";

/** Colours along an edge of the table: `TONE_LUT_SIZE` of the shader. */
const SIZE = 32;

/** How light is shown. */
export interface CompositeOptions {
  /** Share of it that eye and lens scatter. */
  readonly scattered: number;
  /** From places in the picture to those in that of the bloom, as shares of it. */
  readonly haloShift: readonly [number, number];
  readonly metered: boolean;
  readonly kind: GBufferKind;
  /** Where the bloom is, or was in the picture before: pixels of the canvas, and its size. */
  readonly halo: Box;
  readonly size: { readonly width: number; readonly height: number };
}

/** Puts light on paint and the result on the canvas, through a table of the display's law. */
export class CompositePass {
  readonly #gpu: Gpu;
  readonly #screen: VertexArray;
  readonly #show: Readonly<Record<GBufferKind, Program>>;
  /** Moves the picture before to where it is seen now. */
  readonly #again: Program;
  /** Smooths the edges of coarse paint, and brings it to the size of the canvas. */
  readonly #smooth: Program;
  readonly #enlarge: Program;
  #coarse: RenderTarget | null = null;
  #smoothed: RenderTarget | null = null;
  /** The smoothed one, where it is seen a picture later. */
  #moved: RenderTarget | null = null;
  readonly #tabulate: Program;
  readonly #table: Texture;
  /** The law that the table is of. */
  #known = "";

  constructor(gpu: Gpu, screen: VertexArray) {
    this.#gpu = gpu;
    this.#screen = screen;
    this.#show = forEachGBufferKind((defines) =>
      gpu.program("opaque/composite-display", displayVert, showFrag, { defines }),
    );
    this.#again = gpu.program("opaque/reproject-color", fullscreenVert, againFrag);
    this.#smooth = gpu.program("post/fxaa", fullscreenVert, smoothFrag);
    this.#enlarge = gpu.program("post/upscale", fullscreenVert, enlargeFrag);
    this.#tabulate = gpu.program("post/tone-lut", fullscreenVert, tableFrag);
    this.#table = gpu.texture({
      label: "display's table",
      // Bytes are mixed with more bits than they have, and a CPU mixes eight of them twice as fast as floats.
      format: "RGBA8",
      source: { width: SIZE, height: SIZE },
      shape: { layers: SIZE },
    });
  }

  render(
    textures: Lit["textures"] &
      Readonly<Record<"uGBufferAlbedo" | "uDepth" | "uBloom" | "uExposure" | "uToneLut", Texture>>,
    lit: Lit["uniforms"],
    how: CompositeOptions,
    { uAdaptation, uWhite }: DisplayTransform,
    blocks: Readonly<Record<string, UniformBlock>>,
  ): void {
    const shown = {
      program: this.#show[how.kind],
      vertexArray: this.#screen,
      textures,
      uniforms: {
        ...lit,
        uWhiteBalance: uAdaptation.map((gain, i) => gain / (uWhite[i] ?? 1)),
        uGlareShare: how.scattered,
        uGlareOffset: how.haloShift,
        uAutoExposure: how.metered ? 1 : 0,
      },
      blocks,
    };
    if (how.kind === "fine") {
      this.#gpu.draw({ ...shown, target: "canvas" });
      return;
    }
    const isKept = how.kind === "kept";
    if (!isKept) this.#sizeAs(textures.uGBufferAlbedo);
    const [coarse, smoothed, moved] = [this.#coarse, this.#smoothed, this.#moved];
    if (!coarse || !smoothed || !moved) throw new Error("Nothing was shown that can be moved.");
    const target = isKept ? moved : smoothed;
    if (isKept) {
      this.#gpu.draw({
        program: this.#again,
        target,
        vertexArray: this.#screen,
        textures: { uShown: smoothed.color, uDepth: textures.uDepth },
        uniforms: lit,
      });
    }
    // The halo does not move with what is lit.
    const scissor = isKept ? scaleBox(how.halo, how.size, coarse) : undefined;
    this.#gpu.draw({ ...shown, target: coarse, scissor });
    this.#gpu.draw({
      program: this.#smooth,
      target,
      vertexArray: this.#screen,
      textures: { uSource: coarse.color },
      scissor,
    });
    this.#gpu.draw({
      program: this.#enlarge,
      target: "canvas",
      vertexArray: this.#screen,
      textures: { uSource: target.color },
    });
  }

  #sizeAs({ width, height }: Texture): void {
    if (this.#coarse?.width === width && this.#coarse.height === height) return;
    for (const old of [this.#coarse, this.#smoothed, this.#moved]) old?.dispose();
    const target = (label: string) =>
      this.#gpu.renderTarget({ label, width, height, color: ["RGBA8"] });
    this.#coarse = target("shown/coarse");
    this.#smoothed = target("shown/smoothed");
    this.#moved = target("shown/moved");
  }

  /** What is on the screen of each light. */
  table({ uAdaptation: _, ...law }: DisplayTransform): Texture {
    const known = JSON.stringify(law);
    if (known === this.#known) return this.#table;
    this.#known = known;
    for (let layer = 0; layer < SIZE; layer++) {
      const target = this.#gpu.textureView({
        label: `display's table/${layer}`,
        textures: [this.#table],
        image: layer,
      });
      this.#gpu.draw({
        program: this.#tabulate,
        target,
        vertexArray: this.#screen,
        uniforms: { ...law, uLayer: layer },
      });
      target.dispose();
    }
    return this.#table;
  }
}
