import { mat4 } from "gl-matrix";
import radiosityFrag from "../../../shaders/gi/radiosity.frag";
import supportFrag from "../../../shaders/gi/support-radiosity.frag";
import surfelFrag from "../../../shaders/gi/surfel.frag";
import totalRadiosityFrag from "../../../shaders/gi/total-radiosity.frag";
import fullscreenVert from "../../../shaders/post/fullscreen.vert";
import cubeFaceVert from "../../../shaders/shadow/cube-face.vert";
import type { Box, Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { RenderTarget } from "../../gl/render-target.js";
import type { Texture } from "../../gl/texture.js";
import type { UniformBlock } from "../../gl/uniform-block.js";
import type { Vec3 } from "../../world/geometry.js";
import { floats } from "../float-format.js";
import type { CaptureLight } from "../light-block.js";
import { clipFromFace, FACES, isInCubeFace } from "../shadow/cube-map.js";
import type { ShadowCasters } from "../shadow/shadow-casters.js";
import type { IndirectDetail } from "./probe-rays.js";

/** Surfels, captured and lit by a flame or by the moon. */
export interface Surfels
  extends Pick<
    SurfelPass,
    | "normalDistance"
    | "radiosity"
    | "totalRadiosity"
    | "support"
    | "capture"
    | "renderRadiosity"
    | "renderTotalRadiosity"
  > {
  /** The block of the light, by its name. */
  readonly light: Readonly<Record<string, UniformBlock>>;
  /** Which of them each probe sees, where that was traced. */
  readonly visibility: { readonly uSurfelVisibility?: Texture };
  /** Of shaders that read the surfels. */
  readonly defines: Readonly<Record<string, number>>;
}

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
export class SurfelPass implements Surfels {
  readonly #gpu: Gpu;
  readonly #size: number;
  readonly #captureProgram: Program;
  readonly #radiosityProgram: Program;
  readonly #supportProgram: Program;
  readonly #surfels: RenderTarget;
  readonly #radiosity: RenderTarget;
  readonly #totalProgram: Program;
  readonly #total: RenderTarget;
  readonly #support: SupportSlot;
  readonly light: { readonly Light: UniformBlock };
  readonly visibility = {};
  readonly defines = {};

  /** @param support where the radiosity of the candle's support goes */
  constructor(
    gpu: Gpu,
    { surfels: size }: IndirectDetail,
    support: SupportSlot = { supports: supportTarget(gpu, 1), slot: 0 },
  ) {
    this.#gpu = gpu;
    this.#support = support;
    this.#size = size;
    this.#captureProgram = gpu.program("gi/surfel", cubeFaceVert, surfelFrag);
    this.#radiosityProgram = gpu.program("gi/radiosity", fullscreenVert, radiosityFrag);
    this.#supportProgram = gpu.program("gi/support-radiosity", fullscreenVert, supportFrag);
    this.light = { Light: gpu.uniformBlock(this.#radiosityProgram, "Light") };
    const texel = floats(gpu, 4);
    const cube = { width: size * FACES.length, height: size, filter: "nearest" } as const;
    this.#surfels = gpu.renderTarget({
      label: "gi/surfels",
      ...cube,
      color: [texel, texel],
      depth: "buffer",
    });
    const radiosity = (label: string) =>
      gpu.renderTarget({ label, ...cube, color: ["RGBA16F"] as const });
    this.#radiosity = radiosity("gi/radiosity");
    this.#totalProgram = gpu.program("gi/total-radiosity", fullscreenVert, totalRadiosityFrag);
    this.#total = radiosity("gi/total-radiosity");
  }

  /** Normal, and distance from the capture origin. */
  get normalDistance(): Texture {
    return this.#colors.uSurfelNormalDistance;
  }

  /** In direct light, lm/m². */
  get radiosity(): Texture {
    return this.#radiosity.color;
  }

  /** In all light, lm/m². */
  get totalRadiosity(): Texture {
    return this.#total.color;
  }

  /** Of the surface below the flame, for `lib/support-irradiance.glsl`. */
  get support(): Texture {
    return this.#support.supports.color;
  }

  capture(casters: ShadowCasters, captureOrigin: Vec3, face: number): void {
    const size = this.#size;
    const viewport: Box = [face * size, 0, size, size];
    const clipFromWorld = clipFromFace(face, captureOrigin, mat4.create()) as Float32Array;
    this.#gpu.clear(this.#surfels, [0, 0, 0, 0], viewport);
    const pass = {
      program: this.#captureProgram,
      target: this.#surfels,
      viewport,
      uniforms: { uClipFromWorld: clipFromWorld, uCaptureOrigin: captureOrigin },
      depth: "test-and-write",
      cull: "none",
    } as const;
    casters.drawWithAlbedo(pass, (box) => isInCubeFace(face, captureOrigin, box));
  }

  /** Radiosity of the surfels and of the support by a light. */
  renderRadiosity(light: CaptureLight): void {
    this.light.Light.update(light);
    const pass = { textures: this.#colors, blocks: this.light };
    this.#gpu.draw({ ...pass, program: this.#radiosityProgram, target: this.#radiosity });
    this.#gpu.draw({
      ...pass,
      program: this.#supportProgram,
      target: this.#support.supports,
      scissor: [this.#support.slot, 0, 1, 1],
    });
  }

  /** The same with indirect light, by the irradiance volume. */
  renderTotalRadiosity(volume: Readonly<Record<string, Texture>>, block: UniformBlock): void {
    this.#gpu.draw({
      program: this.#totalProgram,
      target: this.#total,
      textures: { ...this.#colors, uRadiosity: this.#radiosity.color, ...volume },
      blocks: { ...this.light, Volume: block },
    });
  }

  get #colors() {
    const [uSurfelReflectance, uSurfelNormalDistance] = this.#surfels.colors;
    if (!uSurfelReflectance || !uSurfelNormalDistance) {
      throw new Error("Surfels take two textures: reflectance, and normal with distance.");
    }
    return { uSurfelReflectance, uSurfelNormalDistance };
  }
}
