import compositeFrag from "../../../shaders/opaque/composite.frag";
import type { Box, Gpu, Program, TextureFormat } from "../../gl/gpu.js";
import type { Vec3 } from "../../world/geometry.js";
import type { Steps } from "../../world/steps.js";
import { isMoonOutdated } from "../cached-light.js";
import type { FrameInput, Size } from "../frame-input.js";
import {
  type FullGBuffer,
  forEachGBufferKind,
  type GBuffer,
  type GBufferKind,
} from "../gbuffer/gbuffer.js";
import { GBufferPass } from "../gbuffer/gbuffer-pass.js";
import { shadingOrigin } from "../gbuffer/shading-origin.js";
import type { Captures } from "../gi/light-captures.js";
import type { MeshLods } from "../mesh/mesh-lods.js";
import type { PhysicalTier } from "../quality.js";
import type { CompositedFrame } from "../volumetric/volumetric-target.js";
import { CachedLighting } from "./cached-lighting.js";
import { LightingPass } from "./lighting-pass.js";
import type { FrameBlocks, OpaqueLayer, OpaqueStage } from "./opaque-stage.js";

const SUPERSAMPLED: FullGBuffer = { samples: 2, pixelsPerStep: Infinity };

/** The opaque stage for machines without a GPU: a G-buffer, lighting at a lower rate, joint bilateral upsampling. */
export class DeferredStage implements OpaqueStage {
  readonly format: TextureFormat;
  readonly blocks: FrameBlocks;
  readonly meterDefines = { DEFERRED: 1, REDUCED: 0 };
  readonly #gpu: Gpu;
  readonly #gbufferPass: GBufferPass;
  readonly #lighting: LightingPass;
  readonly #cached: CachedLighting;
  readonly #composite: Readonly<Record<GBufferKind, Program>>;
  #gbuffer: GBuffer | null = null;
  /** Of the moon that the last frame was lit by: in a running animation it stays until another is captured. */
  #moonDirection: Vec3 | null = null;
  /** G-buffers in motion without a history: the first after rest, and after a view that has little in common with it. */
  images = 0;

  constructor(gpu: Gpu, tier: PhysicalTier, lods: MeshLods, atRest = SUPERSAMPLED) {
    this.#gpu = gpu;
    this.#lighting = new LightingPass(gpu, tier);
    this.format = this.#lighting.format;
    this.blocks = { Frame: this.#lighting.frame, Light: this.#lighting.light };
    const { full } = this.#lighting;
    const summed = { ...this.blocks, Light: gpu.uniformBlock(full, "Light") };
    this.#cached = new CachedLighting(gpu, tier.shadow, this.format, summed, full);
    const jittered = gpu.uniformBlock(full, "Frame");
    this.#gbufferPass = new GBufferPass(gpu, this.blocks.Frame, jittered, lods, atRest);
    this.#composite = forEachGBufferKind((defines) =>
      gpu.pass("opaque/composite", compositeFrag, { defines }),
    );
  }

  resize(size: Size): void {
    this.#cached.release();
    this.#gbufferPass.resize(size);
    this.#lighting.resize(size);
  }

  *fillGBuffer(frame: FrameInput): Steps<GBufferKind> {
    const direction = frame.world.moon?.direction ?? null;
    const shown = frame.settings.canDefer && direction ? this.#moonDirection : null;
    const origin = shadingOrigin(frame, shown ?? direction);
    const gbuffer = yield* this.#gbufferPass.render(frame, this.#lighting.size, origin);
    if (gbuffer.kind === "reduced" && !gbuffer.history) this.images++;
    this.#gbuffer = gbuffer;
    return gbuffer.kind;
  }

  *shade(frame: FrameInput, captures: Captures): Steps<OpaqueLayer> {
    const gbuffer = this.#gbuffer!;
    const { cached } = captures;
    const isAtRest = gbuffer.kind === "full";
    const { moon } = frame.world;
    if (moon && !isMoonOutdated(frame.world, cached)) this.#moonDirection = moon.direction;
    // Compiled while the camera rests.
    if (frame.settings.canDefer && isAtRest) this.#lighting.reducedProgram(cached);
    if (cached.length === 0) this.#cached.release();
    const lit = yield* this.#lighting.render(frame, gbuffer, captures);
    const all =
      isAtRest && cached.length > 0
        ? yield* this.#cached.render(frame, gbuffer, lit.textures.uLighting, cached)
        : null;
    return {
      kind: gbuffer.kind,
      textures: {
        ...lit.textures,
        ...(all && { uLighting: all.uLighting }),
        uGBufferAlbedo: gbuffer.albedo,
        uDepth: gbuffer.depth,
      },
      uniforms: lit.uniforms,
      blocks: { ...this.blocks, Light: all?.Light ?? lit.Light },
      depth: gbuffer.frameDepth,
      gbuffer,
      motion: gbuffer.kind === "reprojected" ? (gbuffer.history?.motion ?? 0) : 0,
    };
  }

  composite(
    _: FrameInput,
    layer: OpaqueLayer,
    { target, tested }: CompositedFrame,
    region: Box,
  ): void {
    const isReduced = layer.kind !== "full";
    if (isReduced) this.#gpu.clear(tested, [0, 0, 0, 1], region);
    this.#gpu.draw({
      program: this.#composite[layer.kind],
      target: isReduced ? tested : target,
      textures: layer.textures,
      uniforms: {
        ...layer.uniforms,
        ...(isReduced && { uSampleOffset: layer.gbuffer!.sampleOffset }),
      },
      blocks: { Light: layer.blocks.Light },
      scissor: region,
      depth: isReduced ? "test-and-write" : "none",
    });
  }
}
