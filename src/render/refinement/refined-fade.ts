import blendVert from "../../../shaders/refinement/blend.vert";
import reprojectFrag from "../../../shaders/refinement/reproject.frag";
import type { Box, Gpu, Program, Texture, UniformBlock } from "../../gl/gpu.js";
import type { Vec3 } from "../../world/geometry.js";
import type { FrameInput, Size } from "../frame-input.js";
import {
  type ReprojectionSource,
  reprojectionBetween,
  reprojectionMatrix,
  reprojectionSource,
} from "../gbuffer/reprojection.js";
import type { FrameBlocks, OpaqueLayer } from "../opaque/opaque-stage.js";

/** Time over which the refined image fades into the coarser one, seconds. */
const TIME = 0.45;
/** Of that, the time in which it is shown alone. */
const SHARP_TIME = 0.1;
/** What a frame counts for, at least and at most, seconds. */
const FRAME = { least: 0.05, most: 0.15 } as const;

/** Ways of the flame over which it fades, too, since its light is that of its own place, metres. */
const NEAR = 0.1;
const FAR = 0.5;

/** A refined image, as it was last shown. */
export interface RefinedImage {
  /** Display colours in two lights, `uReference`, and depth. */
  readonly textures: Readonly<
    Record<"uDimmer" | "uBrighter" | "uReference" | "uRefinedDepth", Texture>
  >;
  readonly source: ReprojectionSource;
  readonly flame: Readonly<Vec3>;
  /** Where that is not the flame's. */
  readonly light: UniformBlock | null;
}

/**
 * The first frames in motion begin with the refined image: it is reprojected over the coarser frame, by the frame's own
 * depth, where the same surface was visible.
 */
export class RefinedFade {
  readonly #gpu: Gpu;
  /** By whether the frame is reprojected itself. */
  readonly #programs: Readonly<Record<"reduced" | "reprojected", Program>>;
  #image: RefinedImage | null = null;
  /** Since the first frame, and of a frame, seconds. */
  #time = 0;
  #frame: number = FRAME.least;

  constructor(gpu: Gpu) {
    this.#gpu = gpu;
    const program = (REPROJECTED: 0 | 1) =>
      gpu.program("refinement/reproject", blendVert, reprojectFrag, { defines: { REPROJECTED } });
    this.#programs = { reduced: program(0), reprojected: program(1) };
  }

  /** Whether the next frame shows anything of it. */
  get isOn(): boolean {
    return this.#image !== null;
  }

  begin(image: RefinedImage): void {
    this.#image = image;
    this.#time = 0;
  }

  /** Takes the time from one frame to the next, seconds. */
  take(seconds: number): void {
    if (seconds > 0) this.#frame = Math.min(Math.max(seconds, FRAME.least), FRAME.most);
  }

  end(): void {
    this.#image = null;
  }

  /**
   * Draws it over the canvas.
   *
   * @param media the part of a frame of `size` that is drawn anew afterwards
   */
  draw(
    { screen, world, instances, clipFromWorld, settings }: FrameInput,
    layer: OpaqueLayer,
    [x, y, width, height]: Box,
    size: Size,
    uExposure: Texture,
    blocks: FrameBlocks,
  ): void {
    const image = this.#image;
    if (!image) return;
    const current = reprojectionSource(instances, clipFromWorld, settings.features);
    const { source, flame } = image;
    const isCut = this.#time === 0 && !reprojectionBetween(current, source);
    const left = TIME - this.#time;
    this.#time += this.#frame;
    const way = Math.hypot(...world.interpolated.flame.map((x, axis) => x - flame[axis]!));
    const share = Math.min((FAR - way) / (FAR - NEAR), left / (TIME - SHARP_TIME), 1);
    const isOver = isCut || current.key !== source.key || share <= 0 || layer.kind === "full";
    if (isOver || this.#time > TIME - FRAME.least / 2) this.end();
    if (isOver) return;
    this.#gpu.draw({
      program: this.#programs[layer.kind],
      target: screen,
      textures: { ...layer.textures, ...image.textures, uExposure },
      uniforms: {
        ...layer.uniforms,
        uRefinedFromCurrentRoom: reprojectionMatrix(current.clipFromWorld, source.clipFromWorld),
        uRefinedFromCurrentHeld: reprojectionMatrix(current.clipFromHeld, source.clipFromHeld),
        uMedia: [
          x / size.width,
          y / size.height,
          (x + width) / size.width,
          (y + height) / size.height,
        ],
        uWeight: share,
        uAutoExposure: settings.features.autoExposure ? 1 : 0,
      },
      blocks: { ...blocks, ...(image.light && { Light: image.light }) },
      blend: "premultiplied",
    });
  }
}
