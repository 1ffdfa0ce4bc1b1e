import copyFrag from "../../../shaders/refinement/copy-tile.frag";
import type { Box, Gpu, Program, RenderTarget } from "../../gl/gpu.js";
import type { Vec3 } from "../../world/geometry.js";
import type { Steps } from "../../world/steps.js";
import type { World } from "../../world/world.js";
import { candlesOf, isMoonAlone, moonOf } from "../cached-light.js";
import { frustumTest } from "../camera.js";
import type { FrameInput, Size } from "../frame-input.js";
import type { FrameSettings } from "../frame-settings.js";
import { type ReprojectionSource, reprojectionSource } from "../gbuffer/reprojection.js";
import type { Captures } from "../gi/light-captures.js";
import { type CaptureLight, shadingLight } from "../light-block.js";
import {
  normalMapVisibilityOf,
  normalMapVisibilityProgram,
} from "../mesh/normal-map-visibility.js";
import {
  areForwardProgramsCompiled,
  forwardProgram,
  nightProgram,
} from "../opaque/forward-programs.js";
import { ForwardStage } from "../opaque/forward-stage.js";
import type { FrameBlocks, OpaqueLayer, OpaqueStage } from "../opaque/opaque-stage.js";
import type { Tier } from "../quality.js";
import type { Surfaces } from "../renderer.js";
import { SCHEDULE } from "../schedule.js";
import { clipOfBox } from "../screen-bounds.js";
import type { ShadowCube } from "../shadow/shadow-pass.js";
import type { CompositedFrame } from "../volumetric/volumetric-target.js";
import { DepthPrepass } from "./depth-prepass.js";
import { ImageLight } from "./image-light.js";
import type { RefinedCaptures } from "./refined-captures.js";
import { RefinedDisplayPass } from "./refined-display-pass.js";
import { TILE, tilesAround } from "./tiles.js";

const BLACK = [0, 0, 0, 1] as const;
const NOTHING = [0, 0, 0] as const;
const WHITE = [1, 1, 1] as const;
/** Frames between draws that compile, so that the GPU is not behind by two of them. */
const REST_FRAMES = 3;
const ONE_PIXEL: Box = [0, 0, 1, 1];

const meshesOf = ({ instances }: FrameInput) => instances.flatMap(({ meshes }) => meshes);

/** The renderer's frames: their input, and how they are drawn, in steps. */
interface Frames {
  describe(world: World, settings: FrameSettings): FrameInput;
  draw(frame: FrameInput): Steps;
}

/**
 * The opaque stage of an image at rest, without a GPU: forward shading, a few tiles in each frame.
 *
 * It begins with a coarser image of the same view, and replaces it tile by tile, nearest the flame first. The light
 * stays where it was at the beginning: the flame's sway moves the shadows by less than is visible.
 */
export class RefinedStage implements OpaqueStage {
  readonly format: ForwardStage["format"];
  readonly blocks: FrameBlocks;
  readonly imageLight: ImageLight;
  readonly meterDefines = { PER_CANDELA: 1 };
  readonly captures: RefinedCaptures;
  readonly display: RefinedDisplayPass;
  readonly #frames: Frames;
  readonly #gpu: Gpu;
  readonly #tier: Tier;
  readonly #forward: ForwardStage;
  readonly #prepass: DepthPrepass;
  readonly #copy: Program;
  /** Of one tile: its samples, and its pixels. */
  readonly #samples: RenderTarget;
  readonly #resolved: RenderTarget;
  /** Radiance per candela of the whole frame, and its depth. */
  #image: RenderTarget | null = null;
  images = 0;
  /** What the last frame was drawn for. */
  source: ReprojectionSource | null = null;
  /** Place of the flame then. */
  flame: Vec3 = [0, 0, 0];
  /** Tiles drawn since the last call of `takeDrawn`. */
  #drawn: Box[] = [];
  /** Still to be drawn. */
  #tiles: Box[] = [];
  #light: CaptureLight | null = null;
  /** With the programs of a flame, of several, or of the moon alone. */
  readonly #firstDraws = new Map<string, Steps>();
  /** Whether the last step has many drivers compile for so long that its frame had better draw nothing else. */
  isCompiling = false;
  /** In progress, of the image that it began with. */
  #firstFrame: Steps | null = null;
  #hasDrawnFirst = false;

  constructor(gpu: Gpu, tier: Tier, captures: RefinedCaptures, frames: Frames) {
    this.#gpu = gpu;
    this.captures = captures;
    this.#frames = frames;
    this.#tier = tier;
    this.#forward = new ForwardStage(gpu, tier);
    normalMapVisibilityProgram(gpu);
    this.#copy = gpu.pass("refinement/copy-tile", copyFrag);
    const tile = { width: TILE, height: TILE, color: ["RGBA16F"], depth: "texture" } as const;
    const { samples } = tier;
    this.#samples = gpu.renderTarget({ label: "refinement/samples", ...tile, samples });
    this.#resolved = gpu.renderTarget({ label: "refinement/tile", ...tile, filter: "nearest" });
    this.format = this.#forward.format;
    this.blocks = this.#forward.blocks;
    const program = forwardProgram(gpu, tier, { isMoonlit: false });
    this.imageLight = new ImageLight(gpu.uniformBlock(program, "Light"));
    this.#prepass = new DepthPrepass(gpu, this.blocks.Frame);
    this.display = new RefinedDisplayPass(gpu, this);
  }

  get remaining(): number {
    return this.#tiles.length;
  }

  /** Shadow cube of the current light, in steps, for the surfaces that it begins with. */
  shadow(world: World, settings: FrameSettings): Steps<ShadowCube> {
    return this.captures.shadow(this.#frames.describe(world, settings));
  }

  /** Begins with the surfaces of a coarser renderer on the same `Gpu`, of the same view, and with the current light. */
  begin(world: World, settings: FrameSettings, coarse: Surfaces): void {
    const frame = this.#frames.describe(world, settings);
    const target = this.#image!;
    this.#firstFrame?.return();
    this.#firstFrame = null;
    this.images++;
    this.#drawn = [];
    this.imageLight.begin(frame);
    this.#light = this.#shadingLight(frame);
    this.#tiles = [];
    this.#gpu.clear(target, BLACK);
    this.#gpu.draw({
      program: this.#copy,
      target,
      textures: { uRadiance: coarse.radiance, uDepth: coarse.depth },
      uniforms: {
        uOrigin: [0, 0],
        uFlamelight: this.imageLight.perCandela(WHITE),
        uMoonlight: NOTHING,
      },
      depth: "test-and-write",
    });
    this.captures.begin(frame, coarse.captures);
  }

  /** Goes on with a first frame off the screen, by a pass: many drivers compile at it. True once it is drawn. */
  drawFirst(world: World, settings: FrameSettings): boolean {
    this.#firstFrame ??= this.#drawOffScreen(this.#frames.describe(world, settings));
    this.#hasDrawnFirst ||= this.#firstFrame.next().done === true;
    return this.#hasDrawnFirst;
  }

  /** Continues captures of the light by `steps` of the settings. True once: when tiles can be drawn in it. */
  prepare(world: World, settings: FrameSettings): boolean {
    this.isCompiling = false;
    const frame = this.#frames.describe(world, settings);
    if (!this.captures.hold(frame, settings.steps ?? 0)) return false;
    const held = this.captures.update(frame, "full");
    const hasCandles = candlesOf(held.cached).length > 0;
    const lights = { isMoonlit: moonOf(held.cached) !== null, hasCandles };
    // Begun before it is asked what is being compiled.
    if (hasCandles) areForwardProgramsCompiled(this.#gpu, this.#tier, lights, meshesOf(frame));
    if (isMoonAlone(frame.world, held.cached)) nightProgram(this.#gpu, this.#tier);
    if (this.#gpu.isCompiling || !this.#hasDrawn(frame, held)) return false;
    this.#tiles = tilesAround(this.#image!, frame.flameUvs[0] ?? [0.5, 0.5]);
    return true;
  }

  resize({ width, height }: Size): void {
    this.#image?.dispose();
    const options = { label: "refinement/radiance", color: [this.format], width, height } as const;
    this.#image = this.#gpu.renderTarget({ ...options, depth: "texture" });
    this.#prepass.resize({ width, height });
  }

  takeDrawn(): readonly Box[] {
    return this.#drawn.splice(0);
  }

  *shade(frame: FrameInput, captures: Captures): Steps<OpaqueLayer> {
    const light = { ...this.#light!, captureOrigin: captures.shadow.captureOrigin };
    const { instances, clipFromWorld, settings } = frame;
    this.source = reprojectionSource(instances, clipFromWorld, settings.features);
    this.flame = [...frame.world.interpolated.flame];
    let steps = settings.steps ?? 0;
    while (steps-- > 0) {
      const tile = this.#tiles.shift();
      if (tile) this.#drawTile(frame, light, captures, tile);
    }
    yield;
    const { color: uRadiance, depth } = this.#image!;
    this.imageLight.update(frame);
    const blocks = { ...this.blocks, Light: this.imageLight.block };
    const textures = { uRadiance, uDepth: depth! };
    return { kind: "full", textures, uniforms: {}, blocks, depth: depth!, motion: 0 };
  }

  /** Goes on with the first draws to a tile's target. */
  #hasDrawn(frame: FrameInput, captures: Captures): boolean {
    const isNight = this.#forward.isNight(frame, captures);
    const light = isNight ? "moon" : candlesOf(captures.cached).length > 0 ? "flames" : "flame";
    const draws = this.#firstDraws.get(light) ?? this.#drawFirstTile(frame, captures);
    this.#firstDraws.set(light, draws);
    return draws.next().done === true;
  }

  /** Many drivers compile a program for a target at its first draw: each in a frame of its own. */
  *#drawFirstTile(frame: FrameInput, captures: Captures): Steps {
    for (const mesh of meshesOf(frame)) normalMapVisibilityOf(this.#gpu, mesh);
    const { shadow } = captures;
    const light = this.#shadingLight(frame);
    for (const isGlossy of [false, true]) {
      for (let rest = 0; rest < REST_FRAMES; rest++) yield;
      this.#forward.draw(frame, { ...light, captureOrigin: shadow.captureOrigin }, captures, {
        target: this.#samples,
        candles: candlesOf(captures.cached),
        isDrawn: (mesh) => mesh.isGlossy === isGlossy,
        scissor: ONE_PIXEL,
        textures: { uPrepassDepth: shadow.depth },
      });
      this.isCompiling = true;
    }
    for (let rest = 0; rest < REST_FRAMES; rest++) yield;
  }

  *#drawOffScreen(frame: FrameInput): Steps {
    const { width, height } = this.#image!;
    const screen = this.#gpu.renderTarget({ label: "screen", width, height, color: ["RGB8"] });
    try {
      yield* this.#frames.draw({ ...frame, screen });
    } finally {
      screen.dispose();
    }
  }

  #shadingLight({ world, settings }: FrameInput) {
    return shadingLight(world, settings.features.candle, SCHEDULE.lighting.forward);
  }

  /** Draws a tile to a multisampled target of its own, since drivers resolve whole targets only. */
  #drawTile(frame: FrameInput, light: CaptureLight, captures: Captures, box: Box): void {
    const target = this.#image!;
    const { width, height } = target;
    const [x, y] = box;
    const moon = moonOf(captures.cached);
    const uPrepassDepth = this.#prepass.depthAround(box, frame);
    this.#gpu.clear(this.#samples, [0, 0, 0, moon?.background ?? 1]);
    this.#forward.draw(frame, light, captures, {
      target: this.#samples,
      candles: this.imageLight.candlesOf(captures.cached),
      carried: this.imageLight.carried,
      viewport: [-x, -y, width, height],
      isVisible: frustumTest(clipOfBox(box, target, frame.clipFromWorld)),
      textures: { uPrepassDepth },
      uniforms: { uOrigin: [x, y] },
    });
    this.#drawn.push(box);
    this.#gpu.resolve(this.#samples, this.#resolved);
    this.#gpu.clear(target, BLACK, box);
    this.#gpu.draw({
      program: this.#copy,
      target,
      textures: { uRadiance: this.#resolved.color, uDepth: this.#resolved.depth! },
      uniforms: {
        uOrigin: [x, y],
        // Where no moonlight enters the room, or by another program than the night's, it is shaded for a flame of 1 cd.
        uFlamelight: this.imageLight.isUnlit ? NOTHING : WHITE,
        uMoonlight: moon ? this.imageLight.perCandela(moon.intensity) : NOTHING,
      },
      depth: "test-and-write",
      scissor: box,
    });
  }

  composite(frame: FrameInput, layer: OpaqueLayer, target: CompositedFrame, region: Box): void {
    this.#forward.composite(frame, layer, target, region);
  }
}
