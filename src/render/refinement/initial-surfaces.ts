import type { Gpu } from "../../gl/gpu.js";
import type { Steps } from "../../world/steps.js";
import { isMoonOutdated } from "../cached-light.js";
import type { FrameInput, Size } from "../frame-input.js";
import type { Captures } from "../gi/light-captures.js";
import { lightBlock } from "../light-block.js";
import type { MeshLods } from "../mesh/mesh-lods.js";
import { DeferredStage } from "../opaque/deferred-stage.js";
import type { FrameBlocks } from "../opaque/opaque-stage.js";
import type { PhysicalTier } from "../quality.js";
import type { InitialImage, Surfaces } from "../renderer.js";
import { SCHEDULE } from "../schedule.js";
import { wholeOf } from "../screen-bounds.js";
import { RadianceTarget } from "../volumetric/volumetric-target.js";

/**
 * Surfaces of an image at rest at the canvas's full resolution, by deferred shading, with which a refinement begins.
 *
 * They take a tenth of the time of forward shading, so that all edges and textures are sharp at once.
 */
export class InitialSurfaces {
  readonly blocks: FrameBlocks;
  readonly #gpu: Gpu;
  readonly #stage: DeferredStage;
  #radiance: RadianceTarget | null = null;

  constructor(gpu: Gpu, tier: PhysicalTier, lods: MeshLods) {
    this.#gpu = gpu;
    const pixelsPerStep = SCHEDULE.refinement.pixels;
    this.#stage = new DeferredStage(gpu, tier, lods, { samples: 1, pixelsPerStep });
    this.blocks = this.#stage.blocks;
  }

  /**
   * @param describe the input of a frame of that size, which does not move
   * @param captures of the light
   */
  begin(size: Size, describe: () => FrameInput, captures: () => Captures): InitialImage {
    this.#resize(size);
    return {
      fill: this.#stage.fillGBuffer(describe()),
      get isMoonOutdated() {
        return isMoonOutdated(describe().world, captures().cached);
      },
      shade: (shadow) => this.#shade(describe(), { ...captures(), shadow }, size),
      release: () => this.#resize({ width: 1, height: 1 }),
    };
  }

  #resize(size: Size): void {
    this.#stage.resize(size);
    this.#radiance?.dispose();
    this.#radiance = new RadianceTarget(this.#gpu, size, this.#stage.format);
  }

  *#shade(frame: FrameInput, captures: Captures, size: Size): Steps<Surfaces> {
    const { world, settings } = frame;
    const layer = yield* this.#stage.shade(frame, captures);
    yield;
    this.blocks.Light.update(lightBlock(world, settings.features.candle));
    const target = this.#radiance!.with(layer.depth);
    this.#stage.composite(frame, layer, target, wholeOf(size));
    return { radiance: target.color, depth: target.depth, captures };
  }
}
