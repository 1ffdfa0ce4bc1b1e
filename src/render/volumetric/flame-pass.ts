import flameFrag from "../../../shaders/volumetric/flame.frag";
import flameVert from "../../../shaders/volumetric/flame.vert";
import type {
  Gpu,
  Program,
  RenderTarget,
  Texture,
  TextureView,
  UniformBlock,
} from "../../gl/gpu.js";
import { BODY_SIZE, outline } from "../../light/flame-body.js";
import { carriedFlame, type RootedFlame, TAPER } from "../../light/flame-light.js";
import { BALLS, createShape, shapeFlame } from "../../light/flame-shape.js";
import type { Vec3 } from "../../world/geometry.js";
import type { World } from "../../world/world.js";

/** Emitters of the flame that are drawn. */
export type FlamePart = "all" | "soot" | "blue";

export interface BurningWick extends RootedFlame {
  /** Nodes of its centre line from the flame's root, the lowest first, metres. */
  readonly nodes: readonly Readonly<Vec3>[];
}

/** Yaw of the candlestick: its handle, along +X in the model, points to the visitor's right hand. */
export const HANDLE_TURN = -1.1;
/** The taper's wick from the foot of the flame, in the model's frame, metres: a test holds it to the model. */
export const TAPER_NODES = [
  [-0.001, -0.0002, -0.0003],
  [-0.0007, 0.0022, -0.0002],
  [0.0006, 0.0049, 0.0001],
  [0.0025, 0.0061, 0.0003],
] as const;
/** A wick of which nothing is known, as high. */
export const UPRIGHT = TAPER_NODES.map(([, y]) => [0, y, 0] as const);
/** Vertices of the hull: six sides of two triangles between rings around the spheres and both ends. */
const HULL_VERTICES = (BALLS + 1) * 6 * 6;

/** Factor on a table of half floats: soot is brighter than the largest of them. */
const HALF_FLOAT_SCALE = 256;

/** The flame, by ray marching within a bounding hull. */
export class FlamePass {
  readonly #gpu: Gpu;
  readonly #program: Program;
  readonly #flame: UniformBlock;
  readonly #body: Texture;
  readonly #outline: Texture;
  readonly #shape = createShape();
  /** From the table's values to radiance. */
  readonly #scale: number;

  /** @param isAlone over a page's background: its outline is antialiased for the display */
  constructor(gpu: Gpu, isAlone = false) {
    this.#gpu = gpu;
    const defines = isAlone ? { ALONE: 1 } : {};
    this.#program = gpu.program("volumetric/flame", flameVert, flameFrag, { defines });
    this.#flame = gpu.uniformBlock(this.#program, "Flame");
    this.#scale = gpu.filtersFloats ? 1 : HALF_FLOAT_SCALE;
    this.#body = gpu.texture({
      label: "flame/body",
      format: gpu.filtersFloats ? "RGBA32F" : "RGBA16F",
      source: { ...BODY_SIZE, data: TAPER.texels.map((x) => x / this.#scale) },
    });
    this.#outline = gpu.texture({
      label: "flame/outline",
      format: gpu.filtersFloats ? "R32F" : "R16F",
      source: {
        width: BODY_SIZE.height,
        height: 1,
        data: Float32Array.from({ length: BODY_SIZE.height }, (_, i) =>
          outline((i + 0.5) / BODY_SIZE.height),
        ),
      },
    });
  }

  /**
   * Adds radiance to the target, with its depth test.
   *
   * @param leastRadius to which the flame is widened, and lengthened to twice of it, metres; its light stays
   */
  render(
    target: RenderTarget | TextureView,
    frame: UniformBlock,
    { root, flame, nodes }: BurningWick,
    steps: number,
    part: FlamePart = "all",
    leastRadius?: number,
  ): void {
    const shape = shapeFlame(flame, TAPER, this.#shape, leastRadius);
    if (!(shape.soot + shape.blue > 0)) return;
    this.#flame.update({
      base: root,
      steps,
      tip: shape.tip,
      extent: shape.length,
      radius: shape.radius,
      soot: part === "blue" ? 0 : shape.soot * this.#scale,
      blue: part === "soot" ? 0 : shape.blue * this.#scale,
      "nodes[0]": shape.nodes,
      "necks[0]": shape.necks,
      "spheres[0]": shape.balls,
      "wick[0]": nodes.flatMap((node) => [...node, 0]),
    });
    this.#gpu.draw({
      program: this.#program,
      target,
      count: HULL_VERTICES,
      textures: { uBody: this.#body, uOutline: this.#outline },
      blocks: { Frame: frame, Flame: this.#flame },
      blend: "premultiplied",
      depth: "test",
    });
  }
}

/** The carried candle's flame; its wick turns with the candle. */
export function carriedWick(world: World): BurningWick {
  const sin = Math.sin(world.interpolated.candleYaw + HANDLE_TURN);
  const cos = Math.cos(world.interpolated.candleYaw + HANDLE_TURN);
  const nodes = TAPER_NODES.map(([x, y, z]): Vec3 => [cos * x + sin * z, y, cos * z - sin * x]);
  return { ...carriedFlame(world), nodes };
}
