import representativeFrag from "../../../shaders/opaque/representative-sample.frag";
import guideFrag from "../../../shaders/opaque/upsample-guide.frag";
import type { Box, Gpu, Program, RenderTarget, Texture } from "../../gl/gpu.js";
import type { Size } from "../frame-input.js";
import type { GBuffer } from "../gbuffer/gbuffer.js";

export type GBufferSamples = Pick<GBuffer, "albedo" | "surface" | "depth">;

/** Resolves a supersampled G-buffer to pixels, each with a guide to the lighting texels of its own surface. */
export class UpsampleGuidePass {
  readonly #gpu: Gpu;
  readonly #chooseRepresentatives: Program;
  readonly #guide: Program;
  #resolved: RenderTarget | null = null;
  #representative: RenderTarget | null = null;

  /** @param samples of the G-buffer along each edge of a pixel */
  constructor(gpu: Gpu, samples: number) {
    this.#gpu = gpu;
    this.#chooseRepresentatives = gpu.pass("opaque/representative-sample", representativeFrag);
    this.#guide = gpu.pass("opaque/upsample-guide", guideFrag, {
      defines: { SAMPLES: samples },
    });
  }

  resize({ width, height }: Size): void {
    this.#resolved?.dispose();
    this.#representative?.dispose();
    this.#representative = null;
    this.#resolved = this.#gpu.renderTarget({
      label: "gbuffer/resolved",
      width,
      height,
      color: ["RGBA8"],
      depth: "texture",
      filter: "nearest",
    });
  }

  /** The resolved G-buffer: albedo with the guide in alpha, and depth. */
  get resolved(): RenderTarget {
    return this.#resolved!;
  }

  get representative(): Texture {
    return this.#representative!.color;
  }

  chooseRepresentatives({ surface, depth }: GBufferSamples, { width, height }: Size): void {
    this.#representative ??= this.#gpu.renderTarget({
      label: "gbuffer/representative samples",
      width,
      height,
      color: ["R8"],
      filter: "nearest",
    });
    this.#gpu.draw({
      program: this.#chooseRepresentatives,
      target: this.#representative,
      textures: { uGBufferSurface: surface, uDepth: depth },
      uniforms: { uLightingSize: [width, height] },
    });
  }

  /** @param scissor part of the frame to resolve; all of it if absent */
  resolve(
    { albedo, surface, depth }: GBufferSamples,
    { width, height }: Size,
    scissor?: Box,
  ): void {
    this.#gpu.clear(this.resolved, [0, 0, 0, 0], scissor);
    this.#gpu.draw({
      program: this.#guide,
      target: this.resolved,
      textures: {
        uAlbedo: albedo,
        uGBufferSurface: surface,
        uDepth: depth,
        uRepresentative: this.representative,
      },
      uniforms: { uLightingSize: [width, height] },
      depth: "test-and-write",
      scissor,
    });
  }
}
