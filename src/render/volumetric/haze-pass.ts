import type { mat4 } from "gl-matrix";
import hazeFrag from "../../../shaders/volumetric/haze.frag";
import hazeVert from "../../../shaders/volumetric/haze.vert";
import copyFrag from "../../../shaders/volumetric/haze-copy.frag";
import type { Gpu, Program, RenderTarget, TextureFormat, UniformBlock } from "../../gl/gpu.js";
import type { RootedFlame } from "../../light/flame-light.js";
import { COLUMN_FLOATS, hotColumn, unsolvedColumn } from "../../world/air/hot-column.js";
import { plumeGrid } from "../../world/air/plume-grid.js";
import type { PlumeSolver } from "../../world/air/plume-solver.js";
import type { Vec3 } from "../../world/geometry.js";
import { projectedExtent, type Sphere } from "../screen-bounds.js";
import type { CompositedFrame } from "./volumetric-target.js";

const GRID = plumeGrid();
const LEVELS = GRID.y.count;
/** Refractive index of the room's air, less 1 (Ciddor 1996, 550 nm, 20 °C). */
const REFRACTION = 2.72e-4;
/**
 * Exaggeration of the angle: a candle deflects a ray by 3e-4 rad at most, which an eye just resolves, but is a
 * fifth of a pixel.
 */
const EXAGGERATION = 16;
/** Heights between which the haze fades in, in heights of the flame: within the flame it has no background. */
const FADE_BEGINS = 0.7;
const FADE_ENDS = 1.6;
/** Least visible deflection, radians. */
const VISIBLE = 5e-4;
/** Half width of the ribbon, in standard deviations of the column: `REACH` of the shader. */
const REACH = 3;
/** The frame is refracted in so many strips, each copied back before the next, to save a copy of all of it. */
const STRIPS = 4;

/** A flame, and the air over it: solved, or the wind that bends its column, m/s. */
export interface HotAir extends RootedFlame {
  readonly air: PlumeSolver | Readonly<Vec3>;
}

/** Heat haze: refraction by the hot air over the flame. */
export class HazePass {
  readonly #gpu: Gpu;
  readonly #format: TextureFormat;
  readonly #refractProgram: Program;
  readonly #copyProgram: Program;
  readonly #plumeColumn = new Float32Array(LEVELS * COLUMN_FLOATS);
  /** Centre and standard deviation of each level, metres. */
  readonly #column = new Float32Array(LEVELS * 4);
  readonly #deflections = new Float32Array(LEVELS);
  #strip: RenderTarget | null = null;
  #size = { width: 1, height: 1 };

  constructor(gpu: Gpu, format: TextureFormat) {
    this.#gpu = gpu;
    this.#format = format;
    this.#refractProgram = this.#program(0);
    const defines = { LEVELS, REFRACTS: 0 };
    this.#copyProgram = gpu.program("volumetric/haze-copy", hazeVert, copyFrag, { defines });
  }

  #program(SHOWS_OFFSET: 0 | 1): Program {
    const defines = { LEVELS, REFRACTS: 1, SHOWS_OFFSET };
    return this.#gpu.program("volumetric/haze", hazeVert, hazeFrag, { defines });
  }

  resize(width: number, height: number): void {
    this.#strip?.dispose();
    this.#size = { width, height };
    const strip = { width: Math.ceil(width / STRIPS), height, color: [this.#format] };
    this.#strip = this.#gpu.renderTarget({ label: "haze/strip", ...strip });
  }

  /**
   * Refracts the background of the column.
   *
   * @param clip clip space from world space, as in `frame`
   * @param showsOffset draws the offset as a colour instead
   */
  render(
    { target, depth, color }: CompositedFrame,
    source: HotAir,
    frame: UniformBlock,
    clip: mat4,
    showsOffset = false,
  ): void {
    if (!this.#strip || !this.#measure(source)) return;
    const { left: begin, right: end, first, count } = this.#visiblePart(clip);
    const ribbon = {
      first,
      count,
      primitive: "strip",
      blocks: { Frame: frame },
      cull: "none",
    } as const;
    const program = showsOffset ? this.#program(1) : this.#refractProgram;
    const { width, height } = this.#size;
    const step = this.#strip.width;
    for (let left = begin; left < end; left += step) {
      const uniforms = { uColumn: this.#column, uStripOrigin: [left, 0] };
      this.#gpu.draw({
        ...ribbon,
        program,
        target: this.#strip,
        textures: { uRadiance: color, uDepth: depth },
        uniforms: {
          ...uniforms,
          uDeflection: this.#deflections,
          uStripTransform: [width / step, (2 * left) / step],
        },
      });
      this.#gpu.draw({
        ...ribbon,
        program: this.#copyProgram,
        target,
        textures: { uSource: this.#strip.color },
        uniforms,
        scissor: [left, 0, Math.min(step, width - left), height],
      });
    }
  }

  #sphere(level: number): Sphere {
    const [x, y, z, width] = this.#column.subarray(4 * level, 4 * level + 4);
    return [x!, y!, z!, REACH * width!];
  }

  /** Levels with visible deflection and one more at each end: columns of pixels, and vertices of the ribbon. */
  #visiblePart(clip: mat4) {
    const { width } = this.#size;
    const isVisible = (deflection: number) => deflection >= VISIBLE;
    const low = Math.max(this.#deflections.findIndex(isVisible) - 1, 0);
    const high = Math.min(this.#deflections.findLastIndex(isVisible) + 1, LEVELS - 1);
    const spheres = Array.from({ length: high - low + 1 }, (_, i) => this.#sphere(low + i));
    const extent = projectedExtent(spheres, clip, this.#size);
    return {
      left: extent ? Math.min(Math.max(Math.floor(extent.left), 0), width) : 0,
      right: extent ? Math.min(Math.max(extent.right, 0), width) : width,
      first: 2 * low,
      count: 2 * (high - low + 1),
    };
  }

  /** Deflection at each level. False if none is visible. */
  #measure({ air, root, flame }: HotAir): boolean {
    if ("heat" in air) hotColumn(air, this.#plumeColumn);
    else unsolvedColumn(GRID, flame, root, air, this.#plumeColumn);
    const foot = "heat" in air ? air.origin[1] : root[1];
    const flameHeight = flame.isLit ? flame.height : 0;
    let largest = 0;
    for (let level = 0; level < LEVELS; level++) {
      const at = level * COLUMN_FLOATS;
      const numbers = this.#plumeColumn.subarray(at, at + COLUMN_FLOATS);
      const [x = 0, y = 0, z = 0, width = 0, deficit = 0] = numbers;
      this.#column.set([x, y, z, width], level * 4);
      // Largest gradient of a Gaussian column, one standard deviation from its centre.
      const steepest = (REFRACTION * deficit) / (width * width * Math.sqrt(2 * Math.PI * Math.E));
      const above = y - foot;
      const share = (above / Math.max(flameHeight, 1e-3) - FADE_BEGINS) / (FADE_ENDS - FADE_BEGINS);
      const top = (LEVELS - 1 - level) / 6;
      const fade = Math.min(Math.max(share, 0), 1) * Math.min(top, 1) * (above > 0 ? 1 : 0);
      this.#deflections[level] = EXAGGERATION * steepest * fade;
      largest = Math.max(largest, EXAGGERATION * steepest * fade);
    }
    return largest >= VISIBLE;
  }
}
