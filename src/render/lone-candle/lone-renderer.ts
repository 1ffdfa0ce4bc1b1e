import type { mat4 } from "gl-matrix";
import type {
  Box,
  Gpu,
  Program,
  RenderTarget,
  Texture,
  UniformBlock,
  UniformValue,
} from "../../gl/gpu.js";
import { adaptedWhite } from "../../light/color.js";
import { ADAPTATION } from "../../light/flame-light.js";
import { nightVision } from "../../light/night-vision.js";
import type { Vec3 } from "../../world/geometry.js";
import type { World } from "../../world/world.js";
import { clipFromWorld, projectionScale } from "../camera.js";
import type { Size } from "../frame-input.js";
import type { FrameSettings } from "../frame-settings.js";
import type { Tier } from "../quality.js";
import type { Renderer } from "../renderer.js";
import type { BurningWick } from "../volumetric/flame-pass.js";
import type { SmokePass } from "../volumetric/smoke-pass.js";

/** Vision of an eye that is adapted to candlelight. */
const LIT = nightVision(0);

export interface LoneCamera {
  readonly eye: Vec3;
  readonly pitch: number;
  readonly fieldOfView: number;
}

/** What a frame is drawn to, and its camera. */
export interface LoneFrame {
  readonly target: RenderTarget;
  readonly clip: mat4;
}

/** The smoke pass of a context; null until its code is there. */
export type SmokePassOf = (gpu: Gpu) => SmokePass | null;

/**
 * Candles and their flames with alpha, over the page's background.
 *
 * It draws to the lower left corner of a canvas that it may share with others.
 */
export abstract class LoneRenderer implements Renderer {
  readonly particles = 0;
  protected readonly gpu: Gpu;
  protected readonly tier: Tier;
  readonly #smokePass: SmokePassOf;
  #samples: RenderTarget | null = null;
  #radiance: RenderTarget | null = null;
  /** Of the two, the one that the last frame was drawn to. */
  #target: RenderTarget | null = null;
  #size = { width: 1, height: 1 };
  /** Columns of the last frame, pixels. */
  #columns = 0;

  constructor(gpu: Gpu, tier: Tier, smokePass: SmokePassOf) {
    this.gpu = gpu;
    this.tier = tier;
    this.#smokePass = smokePass;
  }

  /** Draws nothing before there is a size. */
  render(world: World, settings: FrameSettings): void {
    if (this.#radiance) this.drawFrame(world, settings);
  }

  /** Calls `begin`, draws to its target, and calls `display`. */
  protected abstract drawFrame(world: World, settings: FrameSettings): void;

  resize(width: number, height: number): void {
    const { samples } = this.tier;
    this.#disposeTargets();
    this.#size = { width, height };
    this.#columns = 0;
    const size = { width, height, color: ["RGBA16F"] as const, depth: "buffer" as const };
    this.#samples =
      samples > 1 ? this.gpu.renderTarget({ label: "candle/samples", ...size, samples }) : null;
    this.#radiance = this.gpu.renderTarget({ label: "candle/radiance", ...size });
  }

  /** Its flames have no particles. */
  setLayers(): void {}

  /** Of the canvas, pixels. */
  protected get size(): Size {
    return this.#size;
  }

  protected get aspect(): number {
    return this.#size.width / this.#size.height;
  }

  /**
   * Writes camera and exposure to the block of the frame, and clears the target.
   *
   * @param factor from cd/m² to the display's scale, before the visitor's exposure
   * @param behind depth of what is drawn behind it: the frame has a sample for each pixel then. `kept`: of the last such frame
   */
  protected begin(
    frame: UniformBlock,
    { eye, pitch, fieldOfView }: LoneCamera,
    factor: number,
    { features, exposure }: FrameSettings,
    behind?: "none" | "kept",
  ): LoneFrame {
    const target = ((!behind && this.#samples) || this.#radiance)!;
    this.#target = target;
    const { width, height } = this.#size;
    const clip = clipFromWorld(eye, 0, pitch, this.aspect, fieldOfView);
    frame.update({
      clipFromWorld: clip,
      eyePosition: eye,
      exposure: factor * 2 ** exposure,
      viewport: [width, height],
      projectionScale: projectionScale(Math.min(width, height), fieldOfView),
      normalMaps: features.normalMaps ? 1 : 0,
    });
    this.gpu.clear(target, [0, 0, 0, 0], undefined, behind === "kept");
    return { target, clip };
  }

  protected drawSmoke(
    world: World,
    { target, clip }: LoneFrame,
    frame: UniformBlock,
    uEnvironment: readonly number[],
    wicks: readonly BurningWick[],
  ): void {
    const draw = { target, uniforms: { uEnvironment }, blocks: { Frame: frame } };
    this.#smokePass(this.gpu)?.render(world, clip, draw, wicks);
  }

  /**
   * From the radiance to the canvas.
   *
   * @param share of the columns in the middle that anything is drawn in: the others stay clear
   * @param textures of the program, beside the radiance
   */
  protected display(
    program: Program,
    uniforms: Readonly<Record<string, UniformValue>>,
    blocks: Readonly<Record<string, UniformBlock>>,
    share = 1,
    textures: Readonly<Record<string, Texture>> = {},
  ): void {
    const radiance = this.#radiance!;
    const { width, height } = radiance;
    const left = Math.floor(Math.max(0.5 - 0.5 * share, 0) * width);
    const columns = width - 2 * left;
    const scissor: Box = [left, 0, columns, height];
    if (columns < this.#columns) this.gpu.clear(radiance, [0, 0, 0, 0]);
    this.#columns = columns;
    if (this.#target && this.#target !== radiance)
      this.gpu.resolve(this.#target, radiance, scissor);
    if (columns < width) this.gpu.clear("canvas", [0, 0, 0, 0], [0, 0, width, height]);
    this.gpu.draw({
      program,
      target: "canvas",
      viewport: [0, 0, width, height],
      scissor,
      textures: { uRadiance: radiance.color, ...textures },
      uniforms: {
        uAdaptation: ADAPTATION,
        uWhite: adaptedWhite(),
        uRods: LIT.rods,
        uContrast: LIT.contrast,
        uGlareColor: [1, 0.72, 0.36],
        ...uniforms,
      },
      blocks,
    });
  }

  readRadiance(box: Box): Float32Array {
    return this.gpu.readFloats(this.#radiance!, box);
  }

  #disposeTargets(): void {
    this.#samples?.dispose();
    this.#radiance?.dispose();
    this.#samples = null;
    this.#radiance = null;
  }

  /** Frees the targets; all else is shared. */
  dispose(): void {
    this.#disposeTargets();
  }
}
