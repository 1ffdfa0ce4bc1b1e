import type { Box, Gpu, Texture } from "../gl/gpu.js";
import { nextTask } from "../gl/next-task.js";
import { litFlames } from "../world/flames.js";
import type { ParticleLayer } from "../world/particles/particle-layer.js";
import type { CollisionMesh } from "../world/room/collision-mesh.js";
import { finish, type Steps } from "../world/steps.js";
import type { World } from "../world/world.js";
import { clipPosition } from "./camera.js";
import { carriedPlacement } from "./carried-placement.js";
import { frameBlock } from "./frame-block.js";
import { AT_ORIGIN, type FrameInput, type ModelInstance, type Placement } from "./frame-input.js";
import type { FrameSettings } from "./frame-settings.js";
import type { GBufferKind } from "./gbuffer/gbuffer.js";
import type { IrradianceVolume } from "./gi/irradiance-volume.js";
import { type Captures, LightCaptures } from "./gi/light-captures.js";
import { captureLight, lightBlock } from "./light-block.js";
import { groupTriangles } from "./mesh/clusters.js";
import { type Mesh, sortedByArea, uploadModel } from "./mesh/mesh.js";
import { MeshLods } from "./mesh/mesh-lods.js";
import { CompositeDisplayPass } from "./opaque/composite-display-pass.js";
import { DeferredStage } from "./opaque/deferred-stage.js";
import { ForwardStage } from "./opaque/forward-stage.js";
import type { OpaqueLayer, OpaqueStage } from "./opaque/opaque-stage.js";
import { BLOOM_REACH, BLOOM_SCALE, BloomPass } from "./post/bloom-pass.js";
import {
  DisplayPass,
  displayTransform,
  displayUniforms,
  exposureFactor,
} from "./post/display-pass.js";
import { ExposurePass } from "./post/exposure-pass.js";
import { InspectPass } from "./post/inspect-pass.js";
import { PostTiming } from "./post/post-timing.js";
import type { Tier } from "./quality.js";
import { InitialSurfaces } from "./refinement/initial-surfaces.js";
import { RefinedCaptures } from "./refinement/refined-captures.js";
import type { RefinedDisplayPass } from "./refinement/refined-display-pass.js";
import { RefinedFade } from "./refinement/refined-fade.js";
import { RefinedStage } from "./refinement/refined-stage.js";
import type { Models, Renderer } from "./renderer.js";
import { boundsOf, expandBox, expandBoxes, scaleBox, wholeOf } from "./screen-bounds.js";
import { flamePart, VolumetricStage } from "./volumetric/volumetric-stage.js";
import { RadianceTarget } from "./volumetric/volumetric-target.js";

/**
 * The physical look: a room in the light of a flame, in candela and metres.
 *
 * One frame at every tier: G-buffer, captures of the light, shading, composite, participating media, bloom and
 * exposure, display. Tiers differ in the opaque stage, in what follows from it (bloom of the frame or of the flame
 * alone, a tone LUT, no dust), and in numbers.
 */
export class PhysicalRenderer implements Renderer {
  readonly refining: RefinedStage | null = null;
  readonly refinedFade: RefinedFade | null;
  readonly initialImage?: NonNullable<Renderer["initialImage"]>;
  readonly #gpu: Gpu;
  readonly #room: readonly Mesh[];
  readonly #candle: readonly Mesh[];
  readonly #opaque: OpaqueStage;
  readonly #captures: Pick<LightCaptures, "update" | "steps">;
  readonly #volumetric: VolumetricStage;
  readonly #bloom: BloomPass;
  readonly #exposure: ExposurePass;
  readonly #display: DisplayPass;
  /** Where the composite goes straight to the canvas, but for the volumetric stage's region. */
  readonly #compositeDisplay: CompositeDisplayPass | RefinedDisplayPass | null;
  #inspector: InspectPass | null = null;
  #radiance: RadianceTarget | null = null;
  #size = { width: 1, height: 1 };
  readonly #postTiming = new PostTiming();
  /** The last frame, of which `#radiance` may hold regions. */
  #last: readonly [FrameInput, OpaqueLayer, Captures] | null = null;

  /** @param collision mesh of the room, for the probes' rays */
  constructor(gpu: Gpu, { room, candle }: Models, collision: CollisionMesh, tier: Tier) {
    this.#gpu = gpu;
    const { physical } = tier;
    const isFrugal = physical.opaque !== "forward"; // on machines without a GPU
    const lods = physical.opaque === "deferred" ? new MeshLods(gpu) : null;
    const surfaces = uploadModel(gpu, room, groupTriangles);
    this.#room = sortedByArea(surfaces);
    this.#candle = uploadModel(gpu, candle, groupTriangles);
    const scene = { model: room, collision, surfaces };
    if (physical.opaque === "refined") {
      this.refining = new RefinedStage(gpu, tier, new RefinedCaptures(gpu, scene, physical), {
        describe: (world, settings) => this.#describe(world, settings),
        draw: (frame) => this.#draw(frame),
      });
    }
    this.#opaque =
      this.refining ??
      (lods ? new DeferredStage(gpu, physical, lods) : new ForwardStage(gpu, tier));
    const { format, blocks, meterDefines } = this.#opaque;
    this.#captures =
      this.refining?.captures ?? new LightCaptures(gpu, scene, physical, lods !== null);
    this.#volumetric = new VolumetricStage(gpu, this.#candle, surfaces, blocks, format, physical);
    this.#bloom = new BloomPass(gpu, physical.bloomLevels, format, isFrugal);
    this.#exposure = new ExposurePass(gpu, meterDefines);
    this.#display = new DisplayPass(gpu, isFrugal);
    this.#compositeDisplay = this.refining?.display ?? (lods && new CompositeDisplayPass(gpu));
    this.refinedFade = lods && new RefinedFade(gpu);
    if (lods) {
      let initial: InitialSurfaces | null = null;
      this.initialImage = (world, settings, size) => {
        initial ??= new InitialSurfaces(gpu, physical, lods);
        const { blocks } = initial;
        const atRest = { ...settings, canDefer: false };
        const describe = () => this.#describe(world, atRest, size, blocks);
        return initial.begin(size, describe, () => this.#last![2]);
      };
    }
  }

  resize(width: number, height: number): void {
    this.#size = { width, height };
    this.refinedFade?.end();
    this.#radiance?.dispose();
    this.#opaque.resize(this.#size);
    this.#volumetric.resize(this.#size);
    this.#radiance = new RadianceTarget(this.#gpu, this.#size, this.#opaque.format);
    this.#bloom.resize(width, height);
  }

  setLayers(world: World, layers: readonly ParticleLayer[]): void {
    this.#volumetric.setLayers(world, layers);
  }

  get particles(): number {
    return this.#volumetric.particles;
  }

  async prepare(world: World, settings: FrameSettings, isWanted: () => boolean): Promise<void> {
    const { width, height } = this.#gpu.canvas; // it keeps its image
    const screen = this.#gpu.renderTarget({ label: "screen", width, height, color: ["RGB8"] });
    try {
      for (const _ of this.#prepareInSteps({ ...this.#describe(world, settings), screen })) {
        await this.#gpu.whenIdle();
        await nextTask();
        if (!isWanted()) break;
      }
    } finally {
      screen.dispose();
    }
  }

  /** Many drivers compile a program at its first draw: where frames follow, a few are drawn in advance. */
  *#prepareInSteps(frame: FrameInput): Steps {
    const { settings } = frame;
    const captures = yield* this.#captures.steps(frame);
    yield;
    if (!settings.canDefer) {
      if (this.#opaque.fillGBuffer) yield* this.#opaque.fillGBuffer(frame);
      yield;
      yield* this.#opaque.shade(frame, captures);
      yield;
      return;
    }
    if (this.refinedFade) {
      const moving = { ...frame, settings: { ...settings, isMoving: true } };
      for (let frames = 0; frames < 2; frames++) yield* this.#draw(moving, captures);
      this.resize(this.#size.width, this.#size.height);
    }
    yield* this.#draw(frame, captures);
  }

  render(world: World, settings: FrameSettings): void {
    finish(this.#draw(this.#describe(world, settings)));
  }

  /** @param known captures. Default: they are updated */
  *#draw(frame: FrameInput, known?: Captures): Steps {
    const { world, settings } = frame;
    const kind = this.#opaque.fillGBuffer ? yield* this.#opaque.fillGBuffer(frame) : "full";
    yield;
    // A reprojected frame has the intensity of the frame that it was lit in.
    if (kind !== "reprojected") {
      this.#opaque.blocks.Light.update(lightBlock(world, settings.features.candle));
    }
    const captures = known ?? this.#captures.update(frame, kind);
    const { shadow, irradiance } = captures;
    const layer = yield* this.#opaque.shade(frame, captures);
    yield;
    const regions = this.#compositeDisplay
      ? this.#volumetric.bounds(frame, this.#size, BLOOM_SCALE)
      : [wholeOf(this.#size)];
    if (regions.length > 0) yield* this.#composite(frame, layer, captures, regions);
    yield;
    this.#last = [frame, layer, captures];
    const post = this.#postIn(kind, shadow.isNew, settings);
    if (post === "before display") yield* this.#updatePost(frame, layer, irradiance, regions);
    yield;
    if (settings.inspect !== "picture" && !this.#compositeDisplay) {
      this.#inspect(frame, layer, shadow.depth, irradiance);
    } else yield* this.#present(frame, layer, regions);
    yield;
    if (post === "after display") yield* this.#updatePost(frame, layer, irradiance, regions);
  }

  #describe(
    world: World,
    settings: FrameSettings,
    size = this.#size,
    { Frame } = this.#opaque.blocks,
  ): FrameInput {
    const { interpolated, candle } = world;
    const { features } = settings;
    const block = frameBlock(world, settings, size, exposureFactor(settings));
    Frame.update(block);
    const clip = block.clipFromWorld;
    const candlePlacement = carriedPlacement(world);
    const roots = [interpolated.flame, ...world.standing.map(({ root }) => root)];
    return {
      screen: "canvas",
      world,
      settings,
      clipFromWorld: clip,
      captureLight: captureLight(world, features.candle),
      instances: flamePart(settings.inspect)
        ? []
        : this.#instances(features.candle ? candle : null, candlePlacement),
      candlePlacement,
      flameUvs: roots.map((root) => {
        const [x, y, w] = clipPosition(clip, ...root);
        return w > 0.01 ? [0.5 + (0.5 * x) / w, 0.5 + (0.5 * y) / w] : null;
      }),
    };
  }

  #instances(candle: { readonly isHeld: boolean } | null, placement: Placement): ModelInstance[] {
    const room = { meshes: this.#room, placement: AT_ORIGIN, isHeld: false };
    if (!candle) return [room];
    return [{ meshes: this.#candle, placement, isHeld: candle.isHeld }, room];
  }

  /** Radiance of surfaces and participating media, cd/m², within regions. */
  *#composite(
    frame: FrameInput,
    layer: OpaqueLayer,
    captures: Captures,
    regions: readonly Box[],
  ): Steps {
    const target = this.#radiance!.with(layer.depth);
    if (flamePart(frame.settings.inspect)) this.#gpu.clear(target.target, [0, 0, 0, 1]);
    else for (const region of regions) this.#opaque.composite(frame, layer, target, region);
    yield;
    yield* this.#volumetric.render(frame, target, captures);
  }

  #postIn(kind: GBufferKind, isShadowNew: boolean, { canDefer, isMoving }: FrameSettings) {
    const isAtRest = canDefer && !isMoving;
    const isDeferred = this.#compositeDisplay ? kind !== "full" || canDefer : isAtRest;
    const canSkip = isDeferred && this.#bloom.isDrawn;
    return this.#postTiming.of(kind, { canSkip, isShadowNew, images: this.#opaque.images });
  }

  *#updatePost(
    { flameUvs, world }: FrameInput,
    { textures, blocks }: OpaqueLayer,
    { roomReflectance }: IrradianceVolume,
    regions: readonly Box[],
  ): Steps {
    const { color } = this.#radiance!.whole;
    const lit = litFlames(world);
    this.#bloom.render(
      color,
      regions,
      flameUvs.map((uv, i) => (lit[i] ? uv : null)),
    );
    yield;
    this.#exposure.render(
      this.#compositeDisplay ? textures : { uRadiance: color },
      roomReflectance,
      world.adaptation ?? {},
      { ...blocks },
    );
  }

  /** To the screen: the regions of the media from the radiance, the rest straight from the opaque layer. */
  *#present(frame: FrameInput, layer: OpaqueLayer, regions: readonly Box[]): Steps {
    const { screen, settings, flameUvs, world } = frame;
    const size = this.#size;
    const { blocks } = this.#opaque;
    const inputs = { uBloom: this.#bloom.latest, uExposure: this.#exposure.latest };
    const uRadiance = this.#radiance!.whole.color;
    const transform = displayTransform(this.#gpu, settings, world.adaptation?.darkness ?? 0);
    const uniforms = displayUniforms(transform, settings, this.#bloom.transform(flameUvs));
    const show = (textures: typeof inputs, scissor?: Box) => {
      const all = { ...textures, uRadiance };
      this.#display.render(all, uniforms, transform, blocks.Frame, scissor, screen);
    };
    if (!this.#compositeDisplay) return show(inputs);
    const textures = { ...inputs, uToneLut: this.#compositeDisplay.toneLut(transform) };
    yield;
    const isFilled = regions.some((box) => box[2] * box[3] === size.width * size.height);
    if (layer.kind !== "full" || !isFilled) {
      const options = {
        screen,
        uniforms,
        transform,
        bloomBounds: expandBoxes(regions, BLOOM_REACH + layer.motion * size.width, size),
        size,
      };
      yield* this.#compositeDisplay.render(layer, textures, options, layer.blocks);
      yield;
    }
    this.refinedFade?.draw(frame, layer, boundsOf(regions), size, inputs.uExposure, blocks);
    for (const region of regions) {
      show(textures, scaleBox(expandBox(region, -1, size), size, this.#gpu.canvas));
    }
  }

  #inspect(
    { settings }: FrameInput,
    { depth }: OpaqueLayer,
    uShadow: Texture,
    irradiance: IrradianceVolume,
  ): void {
    this.#inspector ??= new InspectPass(this.#gpu);
    const textures = {
      uRadiance: this.#radiance!.whole.color,
      uBloom: this.#bloom.latest,
      uExposure: this.#exposure.latest,
      uDepth: depth,
      uShadow,
    };
    this.#inspector.render(settings, textures, irradiance, { ...this.#opaque.blocks });
  }

  readRadiance(box: Box): Float32Array {
    if (this.#compositeDisplay && this.#last)
      finish(this.#composite(...this.#last, [wholeOf(this.#size)]));
    return this.#gpu.readFloats(this.#radiance!.whole, box);
  }
}
