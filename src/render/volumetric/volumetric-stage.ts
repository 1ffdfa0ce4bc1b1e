import meshVert from "../../../shaders/mesh/mesh.vert";
import emberFrag from "../../../shaders/volumetric/ember.frag";
import type { Box, Gpu, Program, TextureFormat } from "../../gl/gpu.js";
import { carriedFlame, emberRadiance, type RootedFlame, TAPER } from "../../light/flame-light.js";
import { createShape, shapeFlame } from "../../light/flame-shape.js";
import { scatteredMoonlight } from "../../light/moonlight.js";
import type { Inspection } from "../../settings.js";
import type { Flame } from "../../world/flame/flame.js";
import { type Bounds, inset, type Vec3 } from "../../world/geometry.js";
import type { ParticleLayer } from "../../world/particles/particle-layer.js";
import type { Steps } from "../../world/steps.js";
import type { World } from "../../world/world.js";
import { moonOf } from "../cached-light.js";
import { AT_ORIGIN, type FrameInput, type Placement, type Size } from "../frame-input.js";
import type { Captures } from "../gi/light-captures.js";
import { CHAMBERSTICK } from "../light-block.js";
import type { Mesh } from "../mesh/mesh.js";
import { visibleRuns } from "../mesh/visible-runs.js";
import type { FrameBlocks } from "../opaque/opaque-stage.js";
import type { PhysicalTier } from "../quality.js";
import { mergeOverlapping, pixelSize, type Sphere, screenBounds } from "../screen-bounds.js";
import { RIM } from "../standing-candle-captures.js";
import { type BurningWick, carriedWick, type FlamePart, FlamePass } from "./flame-pass.js";
import { HazePass, type HotAir } from "./haze-pass.js";
import { MotesPass } from "./motes-pass.js";
import { SmokePass, smokeSpheres } from "./smoke-pass.js";
import type { CompositedFrame } from "./volumetric-target.js";
import { type WickShape, wickShape } from "./wick-shape.js";

/** Pixels around the flame that bloom and upsampling read. */
const MARGIN = 3;
/** The hull of the flame is wider than its spheres by this factor at most: `hullVertex` in volumetric/flame.vert. */
const HULL = 1.2;
/** Least radiance of an ember that is drawn, cd/m². */
const FAINTEST_EMBER = 1e-5;
/** Least radius and half height of a flame: one ray a pixel meets a smaller one twice, or not at all. Pixels. */
const LEAST_RADIUS = 1.5;
/** Radius around the flame's root within which the wick glows, metres. */
const EMBER_REACH = 0.01;
/** Colour of a haze that refracts nothing, as `inspect` shows it. */
const NO_OFFSET = [0.5, 0.5, 0.5, 1] as const;

/** Participating media over the opaque surfaces: ember, flame, hot air, dust, smoke, sparks. */
export class VolumetricStage {
  readonly #gpu: Gpu;
  readonly #models: Readonly<Record<"candle" | "room", readonly Mesh[]>>;
  readonly #blocks: FrameBlocks;
  readonly #quality: PhysicalTier;
  readonly #ember: Program;
  readonly #flame: FlamePass;
  readonly #haze: HazePass | null;
  readonly #smoke: SmokePass;
  readonly #motes: MotesPass | null;
  readonly #shape = createShape();

  /** Of the standing candles, by the roots of their flames. */
  readonly #shapes = new WeakMap<Readonly<Vec3>, WickShape>();

  /** @param format of the radiance */
  constructor(
    gpu: Gpu,
    candle: readonly Mesh[],
    room: readonly Mesh[],
    blocks: FrameBlocks,
    format: TextureFormat,
    quality: PhysicalTier,
  ) {
    this.#gpu = gpu;
    const wicks = (meshes: readonly Mesh[]) => meshes.filter(({ isWick }) => isWick);
    this.#models = { candle: wicks(candle), room: wicks(room) };
    this.#blocks = blocks;
    this.#quality = quality;
    this.#ember = gpu.program("volumetric/ember", meshVert, emberFrag);
    this.#flame = new FlamePass(gpu);
    const hasAir = quality.opaque === "forward"; // `low` and the refined image do without
    this.#haze = hasAir ? new HazePass(gpu, format) : null;
    this.#smoke = new SmokePass(gpu, false);
    this.#motes = hasAir ? new MotesPass(gpu) : null;
  }

  resize({ width, height }: Size): void {
    this.#haze?.resize(width, height);
  }

  setLayers(world: World, layers: readonly ParticleLayer[]): void {
    this.#motes?.setLayers(world, layers);
  }

  get particles(): number {
    return this.#motes?.particles ?? 0;
  }

  /** Pixels that anything may be drawn to, as boxes apart from each other, in whole cells of the bloom's source. */
  bounds(frame: FrameInput, size: Size, cell: number): Box[] {
    const fit = { margin: MARGIN, cell };
    const boxes: Box[] = [];
    for (const spheres of this.#spheres(frame, size)) {
      const box = screenBounds(spheres, frame.clipFromWorld, size, fit);
      if (box) boxes.push(box);
    }
    return mergeOverlapping(boxes);
  }

  /** Draws over the composited radiance, within its depth. */
  *render(frame: FrameInput, composited: CompositedFrame, { irradiance, cached }: Captures): Steps {
    const { world, settings, clipFromWorld } = frame;
    const { target, tested } = composited;
    const { features, inspect, isStill } = settings;
    const { Frame, Light } = this.#blocks;
    const part = flamePart(inspect);
    if (inspect === "normals") return;
    if (!part) this.#drawEmbers(frame, composited);
    yield;
    if (features.volume) {
      for (const wick of this.#wicks(world)) {
        const leastRadius = LEAST_RADIUS * pixelSize(wick.root, clipFromWorld, tested);
        const { flameSteps } = this.#quality;
        this.#flame.render(tested, Frame, wick, flameSteps, part ?? "all", leastRadius);
      }
    }
    const { plume } = world;
    if (!plume || part) return;
    const isInspected = inspect === "haze";
    if (isInspected) this.#gpu.clear(target, NO_OFFSET);
    if (this.#haze && (isInspected || features.haze)) {
      for (const hotAir of this.#hotAir(world)) {
        this.#haze.render(composited, hotAir, Frame, clipFromWorld, isInspected);
      }
    }
    if (isInspected) return;
    const moonlight = scatteredMoonlight(moonOf(cached)?.intensity ?? [0, 0, 0]);
    if (features.dust && !isStill) {
      this.#motes?.render("dust", composited, world, Frame, Light, irradiance, moonlight);
    }
    if (features.smoke) {
      const draw = {
        target,
        textures: { uDepth: composited.depth, ...irradiance.textures },
        uniforms: { uMoonlight: moonlight },
        blocks: { Frame, Light, Volume: irradiance.block },
      };
      this.#smoke.render(world, clipFromWorld, draw, this.#wicks(world));
    }
    if (features.sparks && !isStill) {
      this.#motes?.render("spark", composited, world, Frame, Light, irradiance, moonlight);
    }
  }

  /** Of all candles, the carried one's first. */
  #wicks(world: World): readonly BurningWick[] {
    const parts = this.#models.room.map(({ part }) => part);
    const standing = world.standing.map(({ root, flame }) => {
      const shape = this.#shapes.get(root) ?? wickShape(root, parts);
      this.#shapes.set(root, shape);
      return { root, flame, ...shape };
    });
    return [carriedWick(world), ...standing];
  }

  #drawEmbers({ world, settings, candlePlacement }: FrameInput, composited: CompositedFrame): void {
    const [x, y, z] = world.interpolated.foot;
    if (settings.features.candle) {
      const rim: Vec3 = [x, y + CHAMBERSTICK.rim, z];
      this.#drawEmber(this.#models.candle, candlePlacement, rim, world.flame, composited);
    }
    for (const { root, flame } of world.standing) {
      const rim: Vec3 = [root[0], root[1] + RIM.height, root[2]];
      this.#drawEmber(this.#models.room, AT_ORIGIN, rim, flame, composited);
    }
  }

  #drawEmber(
    wicks: readonly Mesh[],
    uPlacement: Placement,
    uRim: Vec3,
    { ember }: Flame,
    { target, depth }: CompositedFrame,
  ): void {
    const uEmber = emberRadiance(ember);
    if (uEmber[0] < FAINTEST_EMBER) return;
    for (const mesh of wicks) {
      for (const run of visibleRuns(mesh, uPlacement, (box) => mayGlow(box, uRim), 1)) {
        this.#gpu.draw({
          program: this.#ember,
          target,
          vertexArray: mesh.vertexArray,
          ...run,
          textures: { uDepth: depth },
          uniforms: { uPlacement, uRim, uEmber },
          blocks: { Frame: this.#blocks.Frame },
          blend: "premultiplied",
        });
      }
    }
  }

  /** Above the carried flame, and above standing ones that burn. */
  *#hotAir({ plume, flame, interpolated, standing, air, sways }: World): Generator<HotAir> {
    if (plume) yield { root: interpolated.flame, flame, air: plume.solver };
    const burning = standing.filter((candle) => candle.flame.isLit);
    for (const { root, flame } of burning.slice(0, this.#quality.mostCandles)) {
      const wind: Vec3 = [0, 0, 0];
      if (sways) air.velocity(root, wind);
      yield { root, flame, air: wind };
    }
  }

  *#flameSpheres({ root, flame }: RootedFlame, pixel: number): Generator<Sphere> {
    const { balls } = shapeFlame(flame, TAPER, this.#shape, LEAST_RADIUS * pixel);
    const [x, y, z] = root;
    for (let at = 0; at < balls.length; at += 4) {
      yield [x + balls[at]!, y + balls[at + 1]!, z + balls[at + 2]!, balls[at + 3]! * HULL];
    }
  }

  /** Spheres around each flame, and each candle's smoke. Tiers that ask for them have no haze. */
  *#spheres(
    { world, settings, clipFromWorld }: FrameInput,
    size: Size,
  ): Generator<Iterable<Sphere>> {
    for (const candle of [carriedFlame(world), ...world.standing]) {
      const [x, y, z] = candle.root;
      const pixel = pixelSize(candle.root, clipFromWorld, size);
      if (candle.flame.glow > 0) yield this.#flameSpheres(candle, pixel);
      else if (emberRadiance(candle.flame.ember)[0] >= FAINTEST_EMBER)
        yield [[x, y, z, EMBER_REACH]];
    }
    if (world.plume && settings.features.smoke) yield* smokeSpheres(world, this.#wicks(world));
  }
}

/** Whether a box may have a part of the wick that glows over this rim. */
function mayGlow(box: Bounds, rim: Vec3): boolean {
  const { min, max } = inset(box, -EMBER_REACH);
  return ([0, 2] as const).every((axis) => rim[axis] > min[axis] && rim[axis] < max[axis]);
}

/** The part of the flame that is inspected alone; null where the room is shown. */
export function flamePart(inspect: Inspection): FlamePart | null {
  if (inspect === "soot" || inspect === "temperature") return "soot";
  return inspect === "blue" ? "blue" : null;
}
