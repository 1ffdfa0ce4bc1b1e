import { nextTask } from "./gl/next-task.js";
import type { FirstPersonInput } from "./input/first-person-input.js";
import { candleLight } from "./light/candle-light.js";
import { type FlameReport, flameReport, paperFlameReport } from "./light/flame-light.js";
import { AutoQuality, type Rung, WORK, type Work } from "./render/auto-quality.js";
import { canvasSize } from "./render/canvas-size.js";
import { type Tier, tierNamed } from "./render/quality.js";
import type { Renderer } from "./render/renderer.js";
import { measureSpeed, type Speed } from "./render/speed.js";
import type { Scene } from "./scenes/scene.js";
import type { Screen } from "./scenes/screen.js";
import type { Features, Inspection, Look, Quality } from "./settings.js";
import type { Wind } from "./world/air.js";
import { STILL } from "./world/intent.js";
import { type Moment, resume } from "./world/moment.js";
import { withCount } from "./world/particle-layer.js";
import {
  advance,
  createWorld,
  currentTime,
  moveCamera,
  standLike,
  type World,
} from "./world/world.js";

/** Longest time that a live frame makes up for, in seconds: after a hidden tab, resume. */
const MAX_FRAME = 1 / 20;
/** Weight of the newest frame in the running mean of frame times. */
const SMOOTHING = 0.1;
const INSPECTION_RUNG: Rung = { tier: "medium", share: 1 };

/** How dear a frame of a scene is. */
function workOf({ isModelAlone }: Scene, { look }: Options): Work {
  return look === "physical" && !isModelAlone ? WORK.physical : WORK.plain;
}

/** Everything about a candle that its owner may set at any time. */
export interface Options {
  readonly look: Look;
  readonly seed: number;
  readonly quality: Quality;
  /** EV */
  readonly exposure: number;
  /** Particles alive; 0 is the look's own count. */
  readonly particles: number;
  readonly wind: Wind;
  /** Diameter of the wick, metres. */
  readonly wick: number;
  readonly unlit: boolean;
  /** No flicker and no sway, for those who asked their system for less motion. */
  readonly isStill: boolean;
}

export interface Stats {
  readonly fps: number;
  readonly frameMs: number;
  readonly cpuMs: number;
  readonly gpuMs: number | null;
  readonly drawCalls: number;
  readonly triangles: number;
  readonly particles: number;
  readonly width: number;
  readonly height: number;
  readonly resolutionScale: number;
  readonly quality: Tier["name"];
  readonly gpuObjects: number;
  readonly gpuBytes: number;
}

/**
 * Input, world, light and renderer, put together on one screen.
 *
 * The world lives as long as this does; the GPU and its renderer come and go with the context.
 */
export class CandleFlame {
  world: World;
  input: FirstPersonInput | null = null;
  /** What is shown of each frame. */
  inspect: Inspection = "picture";
  /** Called after each frame that the animation loop has drawn. */
  onFrame: () => void = () => {};
  /** Called when a frame of the animation loop could not be drawn, or not be held, which ends the loop. */
  onFailure: (error: Error) => void = () => {};
  /** Called when the visitor's input has put the candle down, or taken it up. */
  onCandleMoved: () => void = () => {};
  /** Called when the flame has caught, or gone out, by whatever cause. */
  onFlameChanged: () => void = () => {};
  /** Called when the visitor wanted to put the candle down, and could not. */
  onRefused: () => void = () => {};
  /** Called when the picture is of another quality or resolution than the one before. */
  onQualityChanged: () => void = () => {};
  readonly #screen: Screen;
  #scene: Scene;
  readonly #features: Features;
  #options: Options;
  readonly #auto: AutoQuality;
  #tier: Tier;
  /** Of the tier's resolution. */
  #share: number;
  #renderer: Renderer;
  /** CSS size times device pixel ratio, before the tier's scale. */
  #pixels = { width: 1, height: 1 };
  #request = 0;
  /** Whether a next frame follows each, or will once the first is shown. */
  #isPlaying: boolean;
  /** Whether targets and textures were made since the driver was last asked whether it accepts them. */
  #isUnchecked = false;
  /** Where eye and candle were in the last picture. */
  #stand = "";
  #lastTime = Number.NaN;
  #frameMs = Number.NaN;
  #cpuMs = 0;

  /** How fast a screen's GPU is, for `auto`; measured once, best while it has nothing else to do. */
  static measure({ gpu }: Screen): Promise<Speed | null> {
    return measureSpeed(gpu, () => performance.now() / 1000);
  }

  /**
   * The same as the constructor, in small tasks, so that the page stays responsive.
   *
   * @param isWanted whether anybody still waits for it
   * @returns null where nobody does, or the context was lost
   */
  static async create(
    screen: Screen,
    scene: Scene,
    features: Features,
    options: Options,
    plays: boolean,
    isWanted: () => boolean,
  ): Promise<CandleFlame | null> {
    const { gpu } = screen;
    const isOff = () => !isWanted() || screen.gpu !== gpu || gpu.isLost;
    const auto = new AutoQuality(workOf(scene, options));
    if (options.quality === "auto") auto.speed = await CandleFlame.measure(screen);
    const { tier: name } = plays ? auto.rung : auto.stillRung;
    const tier = tierNamed(options.quality === "auto" ? name : options.quality);
    while (!scene.prepareRenderer(screen, tier, options.look)) {
      await nextTask();
      if (isOff()) return null;
    }
    await nextTask();
    if (isOff()) return null;
    const candle = new CandleFlame(screen, scene, features, options, plays, auto);
    await gpu.whenCompiled();
    if (isOff()) return null;
    gpu.finishPrograms();
    gpu.check("picture");
    return candle;
  }

  /**
   * @param screen from now on this disposes of it
   * @param plays whether time will pass, so that each frame is followed by another
   * @param auto knows the speed of the GPU, where it was measured
   */
  constructor(
    screen: Screen,
    scene: Scene,
    features: Features,
    options: Options,
    plays = false,
    auto = new AutoQuality(workOf(scene, options)),
  ) {
    this.#screen = screen;
    this.#isPlaying = plays;
    this.#scene = scene;
    this.#features = { ...features };
    this.#options = options;
    this.world = this.#createWorld();
    this.#auto = auto;
    this.#tier = this.#tierOf(this.#rung);
    this.#share = this.#rung.share;
    this.#renderer = this.#createRenderer();
  }

  /** `auto` filters anisotropically only where that was measured to be cheap. */
  #tierOf({ tier }: Rung): Tier {
    const { anisotropy, ...rest } = tierNamed(tier);
    const isAllowed = this.#options.quality !== "auto" || this.#auto.allowsAnisotropy;
    return { ...rest, anisotropy: anisotropy && isAllowed };
  }

  /** On the page. */
  get canvas(): HTMLCanvasElement {
    return this.#screen.canvas;
  }

  /** What the next picture is to be drawn with. */
  get #rung(): Rung {
    const { quality } = this.#options;
    const isLow = quality === "low" || (quality === "auto" && this.#auto.rung.tier === "low");
    // Only the dearer tiers draw pass by pass.
    if (this.inspect !== "picture" && isLow) return INSPECTION_RUNG;
    if (quality !== "auto") return { tier: quality, share: 1 };
    return this.#isPlaying ? this.#auto.rung : this.#auto.stillRung;
  }

  /** Turns to another tier or resolution, if the next picture is to have it. */
  #chooseQuality(): void {
    const rung = this.#rung;
    const { share } = rung;
    const isOtherTier = rung.tier !== this.#tier.name;
    if (!isOtherTier && share === this.#share) return;
    this.#tier = this.#tierOf(rung);
    this.#share = share;
    if (isOtherTier) this.#screen.clearUnshared();
    const isOtherSize = this.#fitCanvas();
    const { width, height } = this.#screen.canvas;
    if (isOtherTier) this.#renderer = this.#createRenderer();
    else if (isOtherSize) this.#renderer.resize(width, height);
    this.onQualityChanged();
  }

  #createRenderer(): Renderer {
    const { width, height } = this.#screen.canvas;
    const renderer = this.#scene.createRenderer(this.#screen, this.#tier, this.#options.look);
    renderer.resize(width, height);
    this.#isUnchecked = true;
    this.#follow(renderer);
    return renderer;
  }

  #follow(renderer: Renderer): void {
    if (this.#screen.gpu.isLost) return; // the renderer to come will
    const { layers } = this.world.stage;
    const counted =
      this.#options.particles > 0 ? withCount(layers, this.#options.particles) : layers;
    const drifting = this.#features.drift
      ? counted
      : counted.map((layer) => ({ ...layer, drift: 0 }));
    renderer.setLayers(this.world, drifting);
  }

  /** After a lost context was given back: the same world, seen by a new GPU. */
  restore(): void {
    this.#screen.renew();
    this.#rebuild();
    this.draw();
  }

  #createWorld(age = 0, isLit = !this.#options.unlit, fieldOfView: number | null = null): World {
    const { look, seed, isStill, wind, wick } = this.#options;
    const { room, stage } = this.#scene;
    const world = createWorld(look, seed, {
      age,
      room,
      stage,
      wind,
      wick,
      isLit,
      fieldOfView,
    });
    world.sways = !isStill;
    return world;
  }

  set options(options: Options) {
    const before = this.#options;
    this.#options = options;
    const { air, flame } = this.world;
    this.world.sways = !options.isStill;
    air.wind = options.wind;
    flame.wick = options.wick;
    if (options.look !== before.look) this.#changeLook();
    else if (options.seed !== before.seed) this.reset();
    else if (options.particles !== before.particles) this.#follow(this.#renderer);
    if (options.quality !== before.quality) this.#rebuild();
    if (options.unlit !== before.unlit) this.setLit(!options.unlit);
  }

  /** Lights the candle or puts it out, if it is not so already. */
  setLit(isLit: boolean): void {
    const { flame } = this.world;
    if (isLit ? flame.light() : flame.extinguish()) this.onFlameChanged();
  }

  /** Another scene on the same screen, and what is to be done with it. The old one is no longer used. */
  show(scene: Scene, options: Options): void {
    this.#scene = scene;
    this.#options = options;
    this.#auto.work = workOf(scene, options);
    this.#auto.renew();
    this.world = this.#sameTimeAs(this.world);
    this.#rebuild();
  }

  #rebuild(): void {
    if (this.#screen.gpu.isLost) return; // it is built anew once the context is given back
    const before = { tier: this.#tier.name, share: this.#share };
    const rung = this.#rung;
    const { tier, share } = rung;
    this.#tier = this.#tierOf(rung);
    this.#share = share;
    this.#screen.clear();
    this.#fitCanvas();
    this.#renderer = this.#createRenderer();
    if (before.tier !== tier || before.share !== share) this.onQualityChanged();
  }

  /** A new world at the moment of another, its visitor at the door. */
  #sameTimeAs({ timeline, remainder, flame, fieldOfView }: World): World {
    const world = this.#createWorld(timeline.tick, flame.isLit, fieldOfView);
    world.remainder = remainder;
    return world;
  }

  /** The visitor stays where he is, or inside the new look's walls, at the same moment. */
  #changeLook(): void {
    const { player } = this.world;
    this.#auto.work = workOf(this.#scene, this.#options);
    this.world = this.#sameTimeAs(this.world);
    moveCamera(this.world, player.position, player.yaw, player.pitch);
    this.#follow(this.#renderer);
  }

  /** The moment of another candle, as far as the room here allows. */
  mirror({ world: other }: CandleFlame): void {
    const { player } = other;
    this.world = this.#sameTimeAs(other);
    moveCamera(this.world, player.position, player.yaw, player.pitch);
    standLike(this.world, other);
    this.#follow(this.#renderer);
  }

  /** Goes on from a moment that an earlier candle had here; in another room, at its door. */
  resume(moment: Moment, isSameRoom: boolean): void {
    this.world = this.#createWorld(moment.tick, moment.isLit, moment.fieldOfView);
    this.world.remainder = moment.remainder;
    if (isSameRoom) resume(this.world, moment);
    this.#follow(this.#renderer);
  }

  setFeature(name: keyof Features, isOn: boolean): void {
    if (this.#features[name] === isOn) return;
    this.#features[name] = isOn;
    if (name === "drift") this.#follow(this.#renderer);
  }

  get currentTime(): number {
    return currentTime(this.world);
  }

  /** Time 0, as if new. */
  reset(): void {
    const { isLit } = this.world.flame;
    this.world = this.#createWorld();
    if (this.world.flame.isLit !== isLit) this.onFlameChanged();
    this.#follow(this.#renderer);
  }

  /**
   * Device pixels that the element covers.
   *
   * @returns whether the picture is of another size now, and gone
   */
  resize(width: number, height: number): boolean {
    const isOther = width !== this.#pixels.width || height !== this.#pixels.height;
    this.#pixels = { width, height };
    this.#auto.pixels = width * height;
    if (isOther) this.#auto.renew();
    const { gpu, canvas } = this.#screen;
    const isOtherSize = this.#fitCanvas();
    if (isOtherSize && !gpu.isLost) {
      this.#renderer.resize(canvas.width, canvas.height);
      this.#isUnchecked = true;
    }
    return isOtherSize;
  }

  get #resolutionScale(): number {
    return this.#tier.resolutionScale * this.#share;
  }

  #fitCanvas(): boolean {
    const { canvas } = this.#screen;
    const { longestSide } = this.#screen.gpu;
    const { width, height } = canvasSize(this.#pixels, this.#resolutionScale, longestSide);
    if (width === canvas.width && height === canvas.height) return false;
    canvas.width = width;
    canvas.height = height;
    return true;
  }

  /** One frame. Tests, the bench and the animation loop all come here. */
  step(seconds: number): void {
    const begin = performance.now();
    const { isHeld } = this.world.candle;
    const { isLit } = this.world.flame;
    const intent = this.input?.read() ?? STILL;
    advance(this.world, intent, seconds);
    this.draw();
    this.#cpuMs = performance.now() - begin;
    if (this.world.flame.isLit !== isLit) this.onFlameChanged();
    if (this.world.candle.isHeld !== isHeld) this.onCandleMoved();
    if (intent.placesOrTakes && isHeld) this.onRefused();
  }

  /** The picture of this very moment. Nothing is drawn while the context is lost. */
  draw(): void {
    const { gpu } = this.#screen;
    if (gpu.isLost) return;
    this.#chooseQuality();
    this.#screen.prepare();
    gpu.beginFrame();
    const { exposure, isStill } = this.#options;
    const { gamut } = this.#screen;
    const isPatient = this.#request !== 0;
    const motion = { isMoving: this.#hasMoved() && isPatient, isPatient, isStill };
    const view = { features: this.#features, gamut, exposure, inspect: this.inspect, ...motion };
    this.#renderer.render(this.world, view);
    gpu.endFrame();
    this.#screen.present();
    if (this.#isUnchecked) void this.#check();
  }

  /** Once the GPU has drawn, so that nothing waits for the answer. */
  async #check(): Promise<void> {
    this.#isUnchecked = false;
    const { gpu } = this.#screen;
    await gpu.whenIdle();
    try {
      if (gpu === this.#screen.gpu) gpu.check("picture");
    } catch (error) {
      this.pause();
      this.onFailure(error as Error);
    }
  }

  /** Whether eye or candle are elsewhere than when this was last asked. */
  #hasMoved(): boolean {
    const { player, candle, shown } = this.world;
    const view = [player.yaw, player.pitch, this.world.fieldOfView];
    const stand = [...shown.eye, ...view, ...shown.foot, candle.yaw].join(" ");
    const hasMoved = stand !== this.#stand;
    this.#stand = stand;
    return hasMoved;
  }

  play(): void {
    this.#isPlaying = true;
    if (this.#request !== 0) return;
    this.#lastTime = Number.NaN;
    this.#request = requestAnimationFrame(this.#frame);
  }

  pause(): void {
    this.#isPlaying = false;
    cancelAnimationFrame(this.#request);
    this.#request = 0;
  }

  readonly #frame = (milliseconds: DOMHighResTimeStamp): void => {
    this.#request = requestAnimationFrame(this.#frame);
    const elapsed = milliseconds - this.#lastTime;
    this.#lastTime = milliseconds;
    if (elapsed > 0) {
      const mean = Number.isNaN(this.#frameMs) ? elapsed : this.#frameMs;
      this.#frameMs = mean + (elapsed - mean) * SMOOTHING;
    }
    if (this.#options.quality === "auto") {
      const { milliseconds } = this.#screen.gpu.timer;
      this.#auto.take(elapsed / 1000, milliseconds === null ? null : milliseconds / 1000);
      this.#prepareWanted();
    }
    try {
      this.step(elapsed > 0 ? Math.min(elapsed / 1000, MAX_FRAME) : 0);
    } catch (error) {
      this.pause();
      this.onFailure(error as Error);
      return;
    }
    this.onFrame();
  };

  /** Gets ready, a little in each frame, for a rung of another tier; takes it when nothing holds it up. */
  #prepareWanted(): void {
    const { wanted } = this.#auto;
    if (!wanted) return;
    const tier = this.#tierOf(wanted);
    const isReady =
      wanted.tier === this.#tier.name ||
      this.#scene.prepareRenderer(this.#screen, tier, this.#options.look);
    if (isReady) this.#auto.accept();
  }

  /** Linear RGB of the last frame before exposure and tone mapping; rows from the top. Waits for the GPU. */
  readRadiance(x: number, y: number, width: number, height: number): Float32Array {
    return this.#renderer.readRadiance(x, y, width, height);
  }

  /** The flame, as of the last frame. */
  get flame(): FlameReport {
    if (this.#options.look === "physical") return flameReport(this.world);
    const light = candleLight(this.world, this.#features, this.#options.isStill);
    return paperFlameReport(this.world, light.position);
  }

  get stats(): Stats {
    const { drawCalls, triangles, objectCount, bytes, timer } = this.#screen.gpu;
    const { width, height } = this.#screen.canvas;
    return {
      fps: Number.isNaN(this.#frameMs) ? 0 : 1000 / this.#frameMs,
      frameMs: Number.isNaN(this.#frameMs) ? 0 : this.#frameMs,
      cpuMs: this.#cpuMs,
      gpuMs: timer.milliseconds,
      drawCalls,
      triangles,
      particles: this.#features.particles ? this.#renderer.particles : 0,
      width,
      height,
      resolutionScale: this.#resolutionScale,
      quality: this.#tier.name,
      gpuObjects: objectCount,
      gpuBytes: bytes,
    };
  }

  dispose(): void {
    this.pause();
    this.input?.dispose();
    this.#screen.dispose();
  }
}
