import { mat4 } from "gl-matrix";
import surfaceVert from "../../../shaders/mesh/mesh.vert";
import radianceFrag from "../../../shaders/opaque/composite.frag";
import fullscreenVert from "../../../shaders/post/fullscreen.vert";
import meterFrag from "../../../shaders/post/meter-deferred.frag";
import emberFrag from "../../../shaders/volumetric/ember.frag";
import type { Model } from "../../assets/model.js";
import type { Box, Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { RenderTarget } from "../../gl/render-target.js";
import type { Texture } from "../../gl/texture.js";
import type { TextureView } from "../../gl/texture-view.js";
import type { UniformBlock } from "../../gl/uniform-block.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import { emberRadiance, TAPER } from "../../light/flame-light.js";
import { createShape, shapeFlame } from "../../light/flame-shape.js";
import { fieldOfViewOf } from "../../world/field-of-view.js";
import type { Solid } from "../../world/solid.js";
import type { World } from "../../world/world.js";
import { clipFromWorld, clipPosition, projectionScale, shadowFrustumTest } from "../camera.js";
import { floats } from "../float-format.js";
import type { View } from "../frame-settings.js";
import {
  AT_ORIGIN,
  forEachGBufferKind,
  type GBufferKind,
  type Placed,
} from "../gbuffer/gbuffer.js";
import { GBufferPass } from "../gbuffer/gbuffer-pass.js";
import { type IndirectDetail, IndirectPass, type IrradianceVolume } from "../gi/indirect-pass.js";
import { type CaptureLight, captureLight, lightBlock, shadingLight } from "../light-block.js";
import { groupTriangles } from "../mesh/clusters.js";
import { type Surface, sortedByArea, uploadModel } from "../mesh/mesh.js";
import { MeshLods } from "../mesh/mesh-lods.js";
import {
  DisplayPass,
  displayTransform,
  exposureFactor,
  glareShareOf,
} from "../post/display-pass.js";
import { ExposurePass } from "../post/exposure-pass.js";
import { BLOOM_REACH, BLOOM_SCALE, FlameBloomPass } from "../post/flame-bloom-pass.js";
import type { Models, Renderer } from "../renderer.js";
import { expandBox, type Sphere, screenBounds } from "../screen-bounds.js";
import { ShadowCasters } from "../shadow/shadow-casters.js";
import { ShadowPass } from "../shadow/shadow-pass.js";
import { FlamePass, HANDLE_TURN } from "../volumetric/flame-pass.js";
import { HazePass } from "../volumetric/haze-pass.js";
import { boundingSpheres, SmokePass } from "../volumetric/smoke-pass.js";
import { zoomOf } from "../zoom.js";
import { CompositePass } from "./composite-pass.js";
import { LightingPass } from "./lighting-pass.js";

const SHADOW = { size: 128, search: 4, taps: 8 } as const;
const INDIRECT: IndirectDetail = {
  surfels: 6,
  probes: [5, 3, 5],
  rays: 8,
  bounces: 4,
  testsVisibility: false,
};
/** What of the room may be left out where it throws shadows and light, metres. */
const CASTER_DETAIL = 0.03;
/** The same while the eye moves: shadows of 128 texels a side, and 36 patches of each, tell no more. */
const SLACK_DETAIL = { shadow: 0.05, bounces: 0.12 } as const;
/** Pictures after which bloom and exposure follow, if there is none that has the time, while the eye moves. */
const MOST_PICTURES = 5;
/** Pixels around the flame that its light is mixed with. */
const MARGIN = 3;
/** What throws a shadow into sight from a little out of it, metres. */
const PENUMBRA = 0.05;
/** While the eye moves, surfaces may be a little off, metres: the candle is often in the hand. */
const SLACK = { room: 0.008, candle: 0.001 } as const;

/**
 * The same light as that of `PhysicalRenderer`, where each pixel is dear: without a GPU.
 *
 * Surfaces are drawn sharply and kept while the eye stays where it is; their light, which varies slowly,
 * is worked out at a third of that, and put on them straight to the screen. Where the flame burns the
 * picture is drawn as elsewhere.
 */
export class DeferredRenderer implements Renderer {
  readonly particles = 0;
  readonly #gpu: Gpu;
  readonly #frame: UniformBlock;
  readonly #light: UniformBlock;
  readonly #geometry: GBufferPass;
  readonly #lightPass: LightingPass;
  readonly #show: CompositePass;
  readonly #radianceProgram: Readonly<Record<GBufferKind, Program>>;
  readonly #emberProgram: Program;
  readonly #exposure: ExposurePass;
  readonly #display: DisplayPass;
  readonly #flame: FlamePass;
  readonly #haze: HazePass;
  readonly #smoke: SmokePass;
  readonly #coarse: MeshLods;
  readonly #casters: ShadowCasters;
  /** Coarser ones, for who moves; null until they are ready. */
  #slackCasters: ShadowCasters | null = null;
  #slackEchoers: ShadowCasters | null = null;
  readonly #shadow: ShadowPass;
  readonly #indirect: IndirectPass;
  readonly #halo: FlameBloomPass;
  readonly #model: Model;
  /** In the order of the model's parts, and in that in which they are drawn. */
  readonly #parts: readonly Surface[];
  readonly #room: readonly Surface[];
  readonly #candle: readonly Surface[];
  readonly #screen: VertexArray;
  readonly #shape = createShape();
  #radiance: RenderTarget | null = null;
  /** The radiance alone, and with the depth of the room. */
  #veil: TextureView | null = null;
  readonly #fires = new Map<Texture, TextureView>();
  /** Pictures since the halo was drawn. */
  #haloAge = 0;
  #size = { width: 1, height: 1 };
  #clip = mat4.create();
  /** Draws all of the radiance just shown. */
  #complete: () => void = () => {};

  /** @param solid of the room, as it can be touched */
  constructor(gpu: Gpu, { room, candle }: Models, solid: Solid) {
    this.#gpu = gpu;
    this.#screen = gpu.vertexArray("screen", { attributes: {}, count: 3 });
    this.#lightPass = new LightingPass(gpu, this.#screen, SHADOW);
    this.#frame = this.#lightPass.frame;
    this.#light = this.#lightPass.light;
    this.#coarse = new MeshLods(gpu);
    this.#geometry = new GBufferPass(gpu, this.#screen, this.#coarse);
    this.#show = new CompositePass(gpu, this.#screen);
    this.#radianceProgram = forEachGBufferKind((defines) =>
      gpu.program("opaque/composite", fullscreenVert, radianceFrag, { defines }),
    );
    this.#emberProgram = gpu.program("volumetric/ember", surfaceVert, emberFrag);
    this.#exposure = new ExposurePass(gpu, this.#screen, meterFrag);
    this.#display = new DisplayPass(gpu, this.#screen, true);
    this.#flame = new FlamePass(gpu);
    this.#haze = new HazePass(gpu, this.#lightPass.format);
    this.#smoke = new SmokePass(gpu);
    const surfaces = uploadModel(gpu, room, groupTriangles);
    this.#model = room;
    this.#parts = surfaces;
    this.#room = sortedByArea(surfaces);
    this.#candle = uploadModel(gpu, candle, groupTriangles);
    this.#casters = new ShadowCasters(gpu, room, surfaces, CASTER_DETAIL);
    this.#shadow = new ShadowPass(gpu, SHADOW.size, floats(gpu, 1));
    this.#indirect = new IndirectPass(
      gpu,
      this.#screen,
      { model: room, solid, surfaces },
      INDIRECT,
    );
    this.#halo = new FlameBloomPass(gpu, this.#screen, this.#lightPass.format);
  }

  resize(width: number, height: number): void {
    this.#size = { width, height };
    for (const old of [this.#veil, this.#radiance]) old?.dispose();
    for (const fire of this.#fires.values()) fire.dispose();
    this.#fires.clear();
    this.#geometry.resize(width, height);
    this.#lightPass.resize(width, height);
    this.#haze.resize(width, height);
    const color = [this.#lightPass.format];
    this.#radiance = this.#gpu.renderTarget({ label: "radiance", width, height, color });
    const textures = [this.#radiance.color];
    this.#veil = this.#gpu.textureView({ label: "veil", textures, image: 0 });
    this.#halo.resize(width, height);
  }

  /** The radiance with a depth that hides what is behind it. */
  #fire(depth: Texture): TextureView {
    const known = this.#fires.get(depth);
    if (known) return known;
    const textures = [this.#radiance!.color];
    const fire = this.#gpu.textureView({ label: "fire", textures, image: 0, depth });
    this.#fires.set(depth, fire);
    return fire;
  }

  /** The body of the flame is no particles. */
  setLayers(): void {}

  render(world: World, asked: View): void {
    const { features } = asked;
    this.#updateFrame(world, asked);
    const light = captureLight(world, features.candle);
    const [x, y, z] = world.shown.foot;
    const place = [x, y, z, world.candle.yaw + HANDLE_TURN] as const;
    const placed: Placed[] = [{ surfaces: this.#room, place: AT_ORIGIN, slack: SLACK.room }];
    if (features.candle) {
      const { isHeld } = world.candle;
      placed.unshift({ surfaces: this.#candle, place, slack: SLACK.candle, isHeld: isHeld });
    }
    const paint = this.#geometry.render(placed, this.#frame, {
      clip: this.#clip,
      vantage: light.position,
      features,
      isMoving: asked.isMoving,
      isPatient: asked.isPatient,
      lightSize: this.#lightPass.size,
    });
    const isCoarse = paint.kind !== "fine";
    if (asked.isPatient && !isCoarse) this.#prepareMotion();
    const isKept = paint.kind === "kept";
    // What is shown again is as bright as it was.
    if (!isKept) this.#light.update(lightBlock(world, features.candle));
    const view = { ...asked, isMoving: isCoarse };
    // Of pictures that follow each other one is painted and lit; the next has time for all else.
    const isBusy = paint.kind === "coarse";
    const { shadow, captureOrigin, volume, isNew } = isCoarse
      ? this.#castSlackly(light, isBusy)
      : this.#cast(light);
    const lamp = { ...shadingLight(world, features.candle), captureOrigin };
    const lit = this.#lightPass.render(paint, lamp, shadow, volume, this.#clip, features);
    const picture = { ...lit.textures, uGBufferAlbedo: paint.painted, uDepth: paint.depth };
    const fire = this.#fire(paint.frameDepth);
    const drawRadiance = (box: Box) => {
      if (isCoarse) this.#gpu.clear(fire, [0, 0, 0, 1], box);
      this.#gpu.draw({
        program: this.#radianceProgram[paint.kind],
        target: isCoarse ? fire : this.#veil!,
        vertexArray: this.#screen,
        textures: picture,
        uniforms: lit.uniforms,
        blocks: { Light: this.#light },
        scissor: box,
        depth: isCoarse ? "test-and-write" : "none",
      });
      if (features.candle) this.#drawEmber(world, place, paint.frameDepth);
      if (features.volume) this.#flame.render(fire, this.#frame, world, "low");
      this.#drawHaze(world, view, paint.frameDepth);
      this.#drawSmoke(world, view, volume, paint.frameDepth);
    };
    // Whole cells of what blooms.
    const fit = { margin: MARGIN, cell: BLOOM_SCALE };
    const box = screenBounds(this.#boundingSpheres(world, view), this.#clip, this.#size, fit);
    drawRadiance(box);
    this.#complete = () => drawRadiance(this.#whole);
    const lightBlocks = { Light: this.#light };
    const flameAt = this.#flameOnPicture(world);
    const isHaloDue = ++this.#haloAge > MOST_PICTURES || !(isBusy || isNew);
    const follow = () => {
      this.#haloAge = 0;
      this.#halo.render(this.#radiance!.color, box, flameAt);
      this.#exposure.render(picture, world.pupil.lag, lightBlocks);
    };
    if (!isCoarse || !this.#halo.isDrawn || (isHaloDue && !isKept)) follow();
    const haloShift = this.#halo.shiftFrom(flameAt);
    const law = displayTransform(this.#gpu, view);
    const shown = {
      uBloom: this.#halo.latest,
      uExposure: this.#exposure.latest,
      uToneLut: this.#show.table(law),
    };
    if (isCoarse || box[2] * box[3] < this.#size.width * this.#size.height) {
      const how = {
        scattered: glareShareOf(view),
        haloShift,
        metered: features.autoExposure,
        kind: paint.kind,
        size: this.#size,
        halo: expandBox(
          box,
          BLOOM_REACH + (paint.since?.shift ?? 0) * this.#size.width,
          this.#size,
        ),
      };
      this.#show.render({ ...picture, ...shown }, lit.uniforms, how, law, {
        Frame: this.#frame,
        ...lightBlocks,
      });
    }
    const textures = { ...shown, uRadiance: this.#radiance!.color };
    const halo = { share: [1, 1], shift: haloShift } as const;
    this.#display.render(textures, halo, view, this.#frame, expandBox(box, -1, this.#size));
    if (isHaloDue && isKept) follow();
  }

  /** What the flame sees, from where, and the light that comes back from it. */
  #cast(light: CaptureLight) {
    const shadow = this.#shadow.render(this.#casters, light.position);
    const volume = this.#indirect.render(this.#casters, light);
    return { shadow, captureOrigin: light.position, volume, isNew: false };
  }

  /** The same for one picture among many: of fewer triangles, of those in sight, and a little late. */
  #castSlackly(light: CaptureLight, isBusy: boolean) {
    this.#prepareMotion();
    const isNeeded = shadowFrustumTest(this.#clip, light.position, PENUMBRA);
    const casters = this.#slackCasters ?? this.#casters;
    const shadow = this.#shadow.updateIncrementally(casters, light.position, { isBusy, isNeeded });
    const volume = this.#indirect.updateIncrementally(this.#slackEchoers ?? this.#casters, light);
    return { ...shadow, shadow: shadow.distances, volume };
  }

  /** While the eye rests: what its first move needs, one thing in a picture. */
  #prepareMotion(): void {
    this.#lightPass.prepareMotion();
    if (!this.#slackCasters) this.#slackCasters = this.#slackly(SLACK_DETAIL.shadow);
    else this.#slackEchoers ??= this.#slackly(SLACK_DETAIL.bounces);
  }

  #slackly(detail: number): ShadowCasters | null {
    const parts = this.#coarse.partsOf(this.#parts);
    return parts && new ShadowCasters(this.#gpu, { ...this.#model, parts }, this.#parts, detail);
  }

  get #whole(): Box {
    return [0, 0, this.#size.width, this.#size.height];
  }

  #updateFrame(world: World, view: View): void {
    const { features } = view;
    const { player, shown } = world;
    const { width, height } = this.#size;
    const { yaw, pitch } = player;
    this.#clip = clipFromWorld(shown.eye, yaw, pitch, width / height, fieldOfViewOf(world));
    this.#frame.update({
      clipFromWorld: this.#clip,
      eyePosition: shown.eye,
      exposure: exposureFactor(view),
      viewport: [width, height],
      projectionScale: projectionScale(height) * zoomOf(world),
      normalMaps: features.normalMaps ? 1 : 0,
    });
  }

  #drawEmber(world: World, place: readonly number[], depth: Texture): void {
    const glow = emberRadiance(world.flame.ember);
    if (!(glow[0] > 0)) return;
    for (const { vertexArray, isWick } of this.#candle) {
      if (!isWick) continue;
      this.#gpu.draw({
        program: this.#emberProgram,
        target: this.#veil!,
        vertexArray,
        textures: { uDepth: depth },
        uniforms: { uPlacement: place, uEmber: glow },
        blocks: { Frame: this.#frame, Light: this.#light },
        blend: "premultiplied",
      });
    }
  }

  #drawHaze({ fumes, flame }: World, view: View, depth: Texture): void {
    if (!showsHaze(view) || !fumes) return;
    const veil = { target: this.#veil!, depth };
    const { color } = this.#radiance!;
    const height = flame.isLit ? flame.height : 0;
    this.#haze.render(veil, color, fumes.plume, height, this.#frame, this.#clip);
  }

  #drawSmoke(world: World, view: View, volume: IrradianceVolume, depth: Texture): void {
    if (!this.#hasSmoke(world, view)) return;
    const veil = { target: this.#veil!, depth };
    const { smoke } = world.fumes!;
    this.#smoke.render(veil, smoke, this.#frame, this.#light, volume);
  }

  #hasSmoke({ fumes }: World, { features }: View): boolean {
    return features.smoke && fumes !== null && fumes.smoke.count >= 2;
  }

  /** Bounding spheres of the flame, the hot air over it, and smoke. */
  *#boundingSpheres(world: World, view: View): Generator<Sphere> {
    const { flame, fumes, shown } = world;
    const { balls } = shapeFlame(flame, TAPER, this.#shape);
    const [x, y, z] = shown.flame;
    // The hull is wider than its spheres.
    for (let at = 0; at < balls.length; at += 4) {
      yield [x + balls[at]!, y + balls[at + 1]!, z + balls[at + 2]!, balls[at + 3]! * 1.4];
    }
    if (!fumes) return;
    if (this.#hasSmoke(world, view)) yield* boundingSpheres(fumes.smoke);
    if (!showsHaze(view)) return;
    yield* this.#haze.boundingSpheres(fumes.plume, flame.isLit ? flame.height : 0);
  }

  /** Shares of the picture; its middle for a flame behind the eye, which has no halo. */
  #flameOnPicture({ shown }: World): readonly [number, number] {
    const [x, y, w] = clipPosition(this.#clip, ...shown.flame);
    return w > 0.01 ? [0.5 + (0.5 * x) / w, 0.5 + (0.5 * y) / w] : [0.5, 0.5];
  }

  readRadiance(x: number, y: number, width: number, height: number): Float32Array {
    if (!this.#radiance) return new Float32Array(width * height * 3);
    this.#complete();
    return this.#gpu.readRadiance(this.#radiance, x, y, width, height);
  }
}

/** Nobody who moves sees air tremble by less than a pixel, and it rises over a tenth of the picture. */
function showsHaze({ features, isMoving }: View): boolean {
  return features.haze && !isMoving;
}
