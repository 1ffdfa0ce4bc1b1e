import type { mat4 } from "gl-matrix";
import hazeFrag from "../../../shaders/volumetric/haze.frag";
import hazeVert from "../../../shaders/volumetric/haze.vert";
import copyFrag from "../../../shaders/volumetric/haze-copy.frag";
import type { Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { RenderTarget } from "../../gl/render-target.js";
import type { Texture, TextureFormat } from "../../gl/texture.js";
import type { UniformBlock } from "../../gl/uniform-block.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import { COLUMN_FLOATS, hotColumn } from "../../world/air/hot-column.js";
import { plumeGrid } from "../../world/air/plume-grid.js";
import type { PlumeSolver } from "../../world/air/plume-solver.js";
import { clipPosition } from "../camera.js";
import type { VolumetricTarget } from "./volumetric-target.js";

const LEVELS = plumeGrid().y.count;
/** Refractive index of the room's air, less 1 (Ciddor 1996, 550 nm, 20 °C). */
const REFRACTION = 2.72e-4;
/**
 * How many times stronger than nature: a candle turns a ray by 3e-4 rad at most, a fifth of a pixel
 * where the eye, which has no pixels, just sees it.
 */
const MAGNIFIED = 16;
/** Within the flame there is nothing behind the column but the flame: from here to there it begins. Metres. */
const BEGINS = 0.7;
const BEGUN = 1.6;
/** What is bent by less is not seen to be bent, radians. */
const SEEN = 5e-4;
/** Half of the breadth over which it bends, in standard deviations of the column: `REACH` of the shader. */
const REACH = 3;
/** So much of the picture is bent at once, and what is left of the column after it: no copy of all need be kept. */
const STRIPS = 4;
/** Whoever is nearer to a part of the column may see it anywhere, metres. */
const BESIDE = 0.01;

/** What of the column is drawn: columns of pixels, and vertices of its ribbon. */
interface Stretch {
  readonly left: number;
  readonly right: number;
  readonly first: number;
  readonly count: number;
}

/** Hot air over the flame, as it bends what is seen through it. */
export class HazePass {
  readonly #gpu: Gpu;
  readonly #format: TextureFormat;
  readonly #bend: Program;
  readonly #copy: Program;
  readonly #ribbon: VertexArray;
  readonly #column = new Float32Array(LEVELS * COLUMN_FLOATS);
  readonly #middles = new Float32Array(LEVELS * 4);
  readonly #bends = new Float32Array(LEVELS);
  /** The same, showing how far it bends; made when it is first looked at. */
  #offset: Program | null = null;
  #bent: RenderTarget | null = null;
  #size = { width: 1, height: 1 };

  constructor(gpu: Gpu, format: TextureFormat = "RGBA16F") {
    this.#gpu = gpu;
    this.#format = format;
    const bends = { defines: { LEVELS, BENDS: 1, OFFSET: 0 } };
    this.#bend = gpu.program("volumetric/haze", hazeVert, hazeFrag, bends);
    const copies = { defines: { LEVELS, BENDS: 0 } };
    this.#copy = gpu.program("volumetric/haze-copy", hazeVert, copyFrag, copies);
    this.#ribbon = gpu.vertexArray("haze/ribbon", { attributes: {}, count: 2 * LEVELS });
  }

  resize(width: number, height: number): void {
    this.#bent?.dispose();
    const part = { width: Math.ceil(width / STRIPS), height };
    this.#size = { width, height };
    this.#bent = this.#gpu.renderTarget({
      label: "haze/bent",
      ...part,
      color: [this.#format],
    });
  }

  /**
   * Bends what is behind the column, and touches no other pixel.
   *
   * @param flameHeight of the flame that burns at the column's foot, or 0, metres
   * @param clip space from the room's, as in `frame`
   * @param showsOffset how far, as a colour, instead of what is seen bent
   */
  render(
    { target, depth }: VolumetricTarget,
    radiance: Texture,
    plume: PlumeSolver,
    flameHeight: number,
    frame: UniformBlock,
    clip: mat4,
    showsOffset = false,
  ): void {
    if (!this.#bent || !this.#measure(plume, flameHeight)) return;
    const { left: begin, right: end, first, count } = this.#stretch(clip);
    const ribbon = {
      vertexArray: this.#ribbon,
      first,
      count,
      primitive: "strip",
      blocks: { Frame: frame },
      cull: "none",
    } as const;
    const { width, height } = this.#size;
    const strip = this.#bent.width;
    for (let left = begin; left < end; left += strip) {
      const place = { uMiddle: this.#middles, uCorner: [left, 0] };
      this.#gpu.draw({
        ...ribbon,
        program: showsOffset ? this.#offsetProgram() : this.#bend,
        target: this.#bent,
        textures: { uRadiance: radiance, uDepth: depth },
        uniforms: {
          ...place,
          uBend: this.#bends,
          uStrip: [width / strip, (2 * left) / strip],
        },
      });
      this.#gpu.draw({
        ...ribbon,
        program: this.#copy,
        target,
        textures: { uSource: this.#bent.color },
        uniforms: place,
        scissor: [left, 0, Math.min(strip, width - left), height],
      });
    }
  }

  /** Balls around all that is seen to be bent: x, y, z, radius, metres, of one after another. */
  boundingSpheres(plume: PlumeSolver, flameHeight: number): readonly number[] {
    if (!this.#measure(plume, flameHeight)) return [];
    const balls: number[] = [];
    for (let level = 0; level < LEVELS; level++) {
      if (this.#bends[level]! < SEEN) continue;
      const [x, y, z, breadth] = this.#middles.subarray(4 * level, 4 * level + 4);
      balls.push(x!, y!, z!, REACH * breadth!);
    }
    return balls;
  }

  #offsetProgram(): Program {
    const defines = { LEVELS, BENDS: 1, OFFSET: 1 };
    this.#offset ??= this.#gpu.program("volumetric/haze", hazeVert, hazeFrag, { defines });
    return this.#offset;
  }

  /** Levels that are seen to bend, one more at each end, and the pixels from the leftmost to the rightmost. */
  #stretch(clip: mat4): Stretch {
    const { width } = this.#size;
    const low = Math.max(this.#bends.findIndex((bend) => bend >= SEEN) - 1, 0);
    const high = Math.min(this.#bends.findLastIndex((bend) => bend >= SEEN) + 1, LEVELS - 1);
    let [left, right] = [width, 0];
    for (let level = low; level <= high; level++) {
      const [x, y, z, breadth] = this.#middles.subarray(4 * level, 4 * level + 4);
      const reach = REACH * breadth!;
      for (let corner = 0; corner < 8; corner++) {
        const aside = (axis: number) => ((corner >> axis) & 1 ? reach : -reach);
        const [across, , w] = clipPosition(clip, x! + aside(0), y! + aside(1), z! + aside(2));
        const place = w < BESIDE ? Number.NaN : (0.5 + (0.5 * across) / w) * width;
        left = Math.min(left, place);
        right = Math.max(right, place);
      }
    }
    const isAnywhere = Number.isNaN(left);
    return {
      left: isAnywhere ? 0 : Math.max(Math.floor(left), 0),
      right: isAnywhere ? width : Math.min(right, width),
      first: 2 * low,
      count: 2 * (high - low + 1),
    };
  }

  /** How much each level bends. False if none does so visibly. */
  #measure(plume: PlumeSolver, flameHeight: number): boolean {
    hotColumn(plume, this.#column);
    let most = 0;
    for (let level = 0; level < LEVELS; level++) {
      const at = level * COLUMN_FLOATS;
      const [x, y, z, breadth, missing] = this.#column.subarray(
        at,
        at + COLUMN_FLOATS,
      ) as unknown as [number, number, number, number, number];
      this.#middles.set([x, y, z, breadth], level * 4);
      // A Gaussian column, whose gradient is steepest one breadth from the middle.
      const steepest =
        (REFRACTION * missing) / (breadth * breadth * Math.sqrt(2 * Math.PI * Math.E));
      const above = y - plume.origin[1];
      const share = (above / Math.max(flameHeight, 1e-3) - BEGINS) / (BEGUN - BEGINS);
      const top = (LEVELS - 1 - level) / 6;
      const shown = Math.min(Math.max(share, 0), 1) * Math.min(top, 1) * (above > 0 ? 1 : 0);
      this.#bends[level] = MAGNIFIED * steepest * shown;
      most = Math.max(most, MAGNIFIED * steepest * shown);
    }
    return most >= SEEN;
  }
}
