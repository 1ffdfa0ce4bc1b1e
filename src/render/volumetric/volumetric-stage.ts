import meshVert from "../../../shaders/mesh/mesh.vert";
import emberFrag from "../../../shaders/volumetric/ember.frag";
import type { Box, Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { TextureFormat } from "../../gl/texture.js";
import type { TextureView } from "../../gl/texture-view.js";
import { carriedFlame, emberRadiance, type RootedFlame, TAPER } from "../../light/flame-light.js";
import { createShape, shapeFlame } from "../../light/flame-shape.js";
import type { Inspection } from "../../settings.js";
import type { ParticleLayer } from "../../world/particles/particle-layer.js";
import type { World } from "../../world/world.js";
import type { FrameInput, Size } from "../frame-input.js";
import type { GBufferKind } from "../gbuffer/gbuffer.js";
import type { IrradianceVolume } from "../gi/indirect-pass.js";
import type { Mesh } from "../mesh/mesh.js";
import type { FrameBlocks } from "../opaque/opaque-stage.js";
import type { PhysicalTier } from "../quality.js";
import { type Sphere, screenBounds } from "../screen-bounds.js";
import { carriedWick, type FlamePart, FlamePass } from "./flame-pass.js";
import { HazePass } from "./haze-pass.js";
import { MotesPass } from "./motes-pass.js";
import { boundingSpheres, SmokePass } from "./smoke-pass.js";
import type { CompositedFrame } from "./volumetric-target.js";

/** Pixels around the flame that bloom and antialiasing read. */
const MARGIN = 3;
/** The hull of the flame is drawn wider than its spheres by this factor. */
const HULL = 1.4;
/** Tip of a standing candle's wick from the foot of its flame, metres. */
const UPRIGHT_TIP = [0, 0.0067, 0] as const;
/** Colour of a haze that refracts nothing, as `inspect` shows it. */
const NO_OFFSET = [0.5, 0.5, 0.5, 1] as const;

/** Participating media over the opaque surfaces: ember, flame, hot air, dust, smoke, sparks. */
export class VolumetricStage {
  readonly #gpu: Gpu;
  readonly #wicks: readonly Mesh[];
  readonly #blocks: FrameBlocks;
  readonly #flameSteps: number;
  readonly #hasHaze: boolean;
  readonly #ember: Program;
  readonly #flame: FlamePass;
  readonly #haze: HazePass;
  readonly #smoke: SmokePass;
  readonly #motes: MotesPass | null;
  readonly #shape = createShape();

  /** @param format of the radiance */
  constructor(
    gpu: Gpu,
    candle: readonly Mesh[],
    blocks: FrameBlocks,
    format: TextureFormat,
    quality: Pick<PhysicalTier, "flameSteps" | "hasParticles" | "hasHaze">,
  ) {
    this.#gpu = gpu;
    this.#wicks = candle.filter(({ isWick }) => isWick);
    this.#blocks = blocks;
    this.#flameSteps = quality.flameSteps;
    this.#hasHaze = quality.hasHaze;
    this.#ember = gpu.program("volumetric/ember", meshVert, emberFrag);
    this.#flame = new FlamePass(gpu);
    this.#haze = new HazePass(gpu, format);
    this.#smoke = new SmokePass(gpu);
    this.#motes = quality.hasParticles ? new MotesPass(gpu) : null;
  }

  resize({ width, height }: Size): void {
    this.#haze.resize(width, height);
  }

  /** Replaces the particles by those of a new world, or of other layers. */
  setLayers(world: World, layers: readonly ParticleLayer[]): void {
    this.#motes?.setLayers(world, layers);
  }

  get particles(): number {
    return this.#motes?.particles ?? 0;
  }

  /** Pixels that anything may be drawn to, in whole cells of the bloom's source. */
  bounds(frame: FrameInput, kind: GBufferKind, size: Size, cell: number): Box {
    const fit = { margin: MARGIN, cell };
    return screenBounds(this.#spheres(frame, kind), frame.clipFromWorld, size, fit);
  }

  /** Draws over the composited radiance, within its depth. */
  render(
    frame: FrameInput,
    kind: GBufferKind,
    composited: CompositedFrame,
    irradiance: IrradianceVolume,
  ): void {
    const { world, settings, clipFromWorld } = frame;
    const { target, tested, depth } = composited;
    const { features, inspect, isStill } = settings;
    const { Frame, Light } = this.#blocks;
    const part = flamePart(inspect);
    if (inspect === "normals") return;
    if (features.candle && !part) this.#drawEmber(frame, target, depth);
    if (features.volume) {
      this.#flame.render(tested, Frame, carriedWick(world), this.#flameSteps, part ?? "all");
      for (const candle of world.standing) {
        const wick = { ...candle, tip: UPRIGHT_TIP };
        this.#flame.render(tested, Frame, wick, this.#flameSteps, part ?? "all");
      }
    }
    const { plume, flame } = world;
    if (!plume || part) return;
    const flameHeight = flame.isLit ? flame.height : 0;
    const isInspected = inspect === "haze";
    if (isInspected) this.#gpu.clear(target, NO_OFFSET);
    if (isInspected || this.#showsHaze(frame, kind)) {
      this.#haze.render(composited, plume.solver, flameHeight, Frame, clipFromWorld, isInspected);
    }
    if (isInspected) return;
    if (features.dust && !isStill) {
      this.#motes?.render("dust", composited, world, Frame, Light, irradiance);
    }
    if (features.smoke) {
      this.#smoke.render(composited, plume.smoke, Frame, Light, irradiance);
      for (const { plume: own } of world.standing) {
        if (own) this.#smoke.render(composited, own.smoke, Frame, Light, irradiance);
      }
    }
    if (features.sparks && !isStill) {
      this.#motes?.render("spark", composited, world, Frame, Light, irradiance);
    }
  }

  #drawEmber(
    { world, candlePlacement }: FrameInput,
    target: TextureView,
    uDepth: CompositedFrame["depth"],
  ) {
    const glow = emberRadiance(world.flame.ember);
    if (!(glow[0] > 0)) return;
    for (const { vertexArray } of this.#wicks) {
      this.#gpu.draw({
        program: this.#ember,
        target,
        vertexArray,
        textures: { uDepth },
        uniforms: { uPlacement: candlePlacement, uEmber: glow },
        blocks: { ...this.#blocks },
        blend: "premultiplied",
      });
    }
  }

  /** Refraction of less than a pixel is not visible in motion, and the column covers a tenth of the frame. */
  #showsHaze({ settings }: FrameInput, kind: GBufferKind): boolean {
    return this.#hasHaze && settings.features.haze && kind === "full";
  }

  *#flameSpheres({ root: [x, y, z], flame }: RootedFlame): Generator<Sphere> {
    const { balls } = shapeFlame(flame, TAPER, this.#shape);
    for (let at = 0; at < balls.length; at += 4) {
      yield [x + balls[at]!, y + balls[at + 1]!, z + balls[at + 2]!, balls[at + 3]! * HULL];
    }
  }

  /** Spheres around the flames, the hot air over them, and the smoke. */
  *#spheres(frame: FrameInput, kind: GBufferKind): Generator<Sphere> {
    const { flame, plume, standing } = frame.world;
    yield* this.#flameSpheres(carriedFlame(frame.world));
    for (const candle of standing) {
      if (candle.flame.glow > 0) yield* this.#flameSpheres(candle);
      const own = frame.settings.features.smoke ? candle.plume : null;
      if (own && own.smoke.count >= 2) yield* boundingSpheres(own.smoke);
    }
    if (!plume) return;
    const { smoke } = frame.settings.features;
    if (smoke && plume.smoke.count >= 2) yield* boundingSpheres(plume.smoke);
    if (!this.#showsHaze(frame, kind)) return;
    yield* this.#haze.boundingSpheres(plume.solver, flame.isLit ? flame.height : 0);
  }
}

/** The part of the flame that is inspected alone; null where the room is shown. */
export function flamePart(inspect: Inspection): FlamePart | null {
  if (inspect === "soot" || inspect === "temperature") return "soot";
  return inspect === "blue" ? "blue" : null;
}
