import flameFrag from "../../../shaders/physical/flame.frag";
import flameVert from "../../../shaders/physical/flame.vert";
import type { Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { RenderTarget } from "../../gl/render-target.js";
import type { Texture } from "../../gl/texture.js";
import type { UniformBlock } from "../../gl/uniform-block.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import { BODY_SIZE, outline } from "../../light/flame-body.js";
import { TAPER } from "../../light/flame-light.js";
import type { World } from "../../world/world.js";
import type { Tier } from "../tier.js";

/** Steps of the march through the flame. */
const STEPS: Readonly<Record<Tier["name"], number>> = {
  low: 12,
  medium: 24,
  high: 40,
  ultra: 64,
};

/** The flame's body, gathered along each pixel's ray within a hull around it. */
export class FlamePass {
  readonly #gpu: Gpu;
  readonly #program: Program;
  readonly #flame: UniformBlock;
  readonly #body: Texture;
  readonly #outline: Texture;
  readonly #hull: VertexArray;

  constructor(gpu: Gpu) {
    this.#gpu = gpu;
    this.#program = gpu.program("physical/flame", flameVert, flameFrag);
    this.#flame = gpu.uniformBlock(this.#program, "Flame");
    this.#body = gpu.texture({
      label: "flame/body",
      format: "RGBA32F",
      source: { ...BODY_SIZE, data: TAPER.texels },
    });
    this.#outline = gpu.texture({
      label: "flame/outline",
      format: "R32F",
      source: {
        width: BODY_SIZE.height,
        height: 1,
        data: Float32Array.from({ length: BODY_SIZE.height }, (_, i) =>
          outline((i + 0.5) / BODY_SIZE.height),
        ),
      },
    });
    this.#hull = gpu.vertexArray("flame/hull", { attributes: {}, count: 14 });
  }

  /** Radiance is added to the target, behind what stands in front of the flame. */
  render(target: RenderTarget, frame: UniformBlock, world: World, tier: Tier["name"]): void {
    const [x, y, z] = world.shown.flame;
    this.#flame.update({
      base: [x, y, z],
      radius: TAPER.radius,
      tip: [x, y + TAPER.height, z],
      steps: STEPS[tier],
    });
    this.#gpu.draw({
      program: this.#program,
      target,
      vertexArray: this.#hull,
      primitive: "strip",
      textures: { uBody: this.#body, uOutline: this.#outline },
      blocks: { Frame: frame, Flame: this.#flame },
      blend: "premultiplied",
      depth: "test",
      cull: "none",
    });
  }
}
