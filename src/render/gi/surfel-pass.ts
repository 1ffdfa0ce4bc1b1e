import supportFrag from "../../../shaders/gi/support-radiosity.frag";
import totalRadiosityFrag from "../../../shaders/gi/total-radiosity.frag";
import type { Gpu, Program, RenderTarget, Texture, UniformBlock } from "../../gl/gpu.js";
import type { Vec3 } from "../../world/geometry.js";
import { frustumTest } from "../camera.js";
import { floats } from "../float-format.js";
import type { CaptureLight } from "../light-block.js";
import { clipFromFace } from "../shadow/cube-map.js";
import type { ShadowCasters } from "../shadow/shadow-casters.js";
import type { IndirectDetail } from "./probe-rays.js";
import { Surfels } from "./surfels.js";

/** The texel of a candle's support in a texture of those of several. */
export interface SupportSlot {
  readonly supports: RenderTarget;
  readonly slot: number;
}

/** A texture of the radiosity of candles' supports, a texel each. */
export function supportTarget(gpu: Gpu, slots: number): RenderTarget {
  return gpu.renderTarget({
    label: "gi/support-radiosity",
    width: slots,
    height: 1,
    color: [floats(gpu, 4)],
    filter: "nearest",
  });
}

/** Surfels: the surfaces that the flame lights, a cube around it: `lib/surfels.glsl`. */
export class SurfelPass extends Surfels {
  readonly #supportProgram: Program;
  readonly #support: SupportSlot;
  readonly #totalProgram: Program;
  readonly #total: RenderTarget;

  /** @param support where the radiosity of the candle's support goes */
  constructor(
    gpu: Gpu,
    { surfels: size }: IndirectDetail,
    support: SupportSlot = { supports: supportTarget(gpu, 1), slot: 0 },
  ) {
    super(gpu, size, "Light");
    this.#support = support;
    this.#supportProgram = gpu.pass("gi/support-radiosity", supportFrag);
    this.#totalProgram = gpu.pass("gi/total-radiosity", totalRadiosityFrag);
    this.#total = this.target("gi/total-radiosity");
  }

  override get totalRadiosity(): Texture {
    return this.#total.color;
  }

  override get support(): Texture {
    return this.#support.supports.color;
  }

  capture(casters: ShadowCasters, captureOrigin: Vec3, face: number): void {
    const { size } = this;
    const uClipFromWorld = clipFromFace(face, captureOrigin);
    const uniforms = { uClipFromWorld, uCaptureOrigin: captureOrigin };
    const draw = { viewport: [face * size, 0, size, size], uniforms } as const;
    this.draw(casters, draw, frustumTest(uClipFromWorld));
  }

  /** And of the support. */
  override renderRadiosity(light: CaptureLight): void {
    super.renderRadiosity(light);
    this.gpu.draw({
      program: this.#supportProgram,
      target: this.#support.supports,
      textures: this.textures,
      blocks: this.blocks,
      scissor: [this.#support.slot, 0, 1, 1],
    });
  }

  override renderTotalRadiosity(
    volume: Readonly<Record<string, Texture>>,
    block: UniformBlock,
  ): void {
    this.gpu.draw({
      program: this.#totalProgram,
      target: this.#total,
      textures: { ...this.textures, uRadiosity: this.radiosity, ...volume },
      blocks: { ...this.blocks, Volume: block },
    });
  }
}
