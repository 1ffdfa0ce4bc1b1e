import { AnimationLoop } from "./animation-loop.js";
import type { FirstPersonInput } from "./input/first-person-input.js";
import { candleLight } from "./light/candle-light.js";
import {
  carriedFlame,
  type FlameReport,
  flameReport,
  paperFlameReport,
} from "./light/flame-light.js";
import type { AutoQuality } from "./render/auto-quality.js";
import { Reports } from "./reports.js";
import { type Options, SceneWorlds } from "./scene-worlds.js";
import type { CanvasTarget } from "./scenes/canvas-target.js";
import type { Scene } from "./scenes/scene.js";
import { SceneView } from "./scenes/scene-view.js";
import type { ViewSubject } from "./scenes/view-subject.js";
import type { Features } from "./settings.js";
import type { Stats } from "./stats.js";
import { advance } from "./world/advance.js";
import { candleCount, litFlames, rootedFlame, wickAtFlame } from "./world/flames.js";
import { withCount } from "./world/particles/particle-layer.js";
import { STILL } from "./world/player/intent.js";
import { currentTime, type World } from "./world/world.js";

export type { Options } from "./scene-worlds.js";

/** Longest time step of a live frame, seconds: a tab that was hidden does not fast-forward. */
const MAX_FRAME = 1 / 20;

/**
 * Composition of input, world, light and renderer on one canvas.
 *
 * The world has this object's lifetime; the GPU and its renderer have the context's.
 */
export class CandleFlame {
  world: World;
  input: FirstPersonInput | null = null;
  /** Called after each frame that the animation loop has drawn. */
  onFrame: () => void = () => {};
  /** Called when a frame of the animation loop could not be drawn, or not be held, which ends the loop. */
  onFailure: (error: Error) => void = () => {};
  /** Called when the candle was put down or taken up, by the visitor or with a new world. */
  onCandleMoved: (isHeld: boolean) => void = () => {};
  /** Called when a candle was lit or went out, for any reason; 0 is the carried one. By now it may be otherwise. */
  onFlameChanged: (index: number, isLit: boolean) => void = () => {};
  /** Called when the carried flame was brought to the wick of another candle, which E would light now. */
  onWickReached: (index: number) => void = () => {};
  /** Called when the candle could not be put down where the visitor asked. */
  onRefused: () => void = () => {};
  /** Called when another look is drawn, of the same scene. */
  onLookChanged: () => void = () => {};
  /** Of candles that were lit, went out or moved. */
  readonly reports = new Reports();
  #scene: Scene;
  readonly #features: Features;
  #options: Options;
  readonly view: SceneView;
  readonly #loop: AnimationLoop;
  /** Places of camera and candle in the last frame. */
  #pose = "";
  #cpuMs = 0;
  /** Candle whose wick the carried flame is at; 0 if none. */
  #wick = 0;

  /**
   * @param target from now on this disposes of it
   * @param features may be changed from outside: `followFeature`
   * @param plays whether time will pass, so that each frame is followed by another
   * @param prepared the quality to begin with, and a new world of the scene
   */
  constructor(
    target: CanvasTarget,
    scene: Scene,
    features: Features,
    options: Options,
    plays = false,
    prepared?: { readonly auto: AutoQuality; readonly world: World },
  ) {
    this.#loop = new AnimationLoop((elapsed) => this.#frame(elapsed), target.canvas);
    this.#scene = scene;
    this.#features = features;
    this.#options = options;
    this.world = prepared?.world ?? this.#worlds.first();
    this.view = new SceneView(target, scene, options, this.#subject, plays, prepared?.auto);
    this.view.onRefused = (error) => this.#fail(error);
  }

  get #subject(): ViewSubject {
    const { world } = this;
    const { particles } = this.#options;
    const layers = particles > 0 ? withCount(world.setup.layers, particles) : world.setup.layers;
    const isDrifting = this.#features.drift;
    return { world, layers: isDrifting ? layers : layers.map((one) => ({ ...one, drift: 0 })) };
  }

  /** After a lost context was restored: the same world, drawn by a new GPU, in small tasks where time passes. */
  async restore(plays: boolean, isWanted: () => boolean): Promise<void> {
    this.view.restore(plays);
    if (plays) await this.prepareFrame(plays, isWanted);
    else this.draw();
  }

  get #worlds(): SceneWorlds {
    return new SceneWorlds(this.#scene, this.#options);
  }

  set options(options: Options) {
    const before = this.#options;
    this.#options = options;
    this.view.settings = options;
    const { air, flame } = this.world;
    this.world.sways = !options.isStill;
    this.world.moon = this.#worlds.moon;
    air.wind = options.wind;
    flame.wick = this.#worlds.wick;
    const isOtherLook = options.look !== before.look;
    if (isOtherLook && !this.#scene.isModelAlone) this.#replace(this.#worlds.inLook(this.world));
    else if (options.seed !== before.seed) this.#restart();
    else if (options.particles !== before.particles) this.view.follow(this.#subject);
    const burning = ({ unlit, litWicks }: Options) => `${unlit} ${litWicks}`;
    if (burning(options) !== burning(before)) this.#noting(() => this.#burnAsAtFirst());
    // Last what calls listeners: they may set other options.
    if (isOtherLook) this.onLookChanged();
    if (options.quality !== before.quality) this.view.rebuild();
    this.reports.tell();
  }

  #burnAsAtFirst(): void {
    this.world.formerLit = [];
    for (let index = 0; index < candleCount(this.world); index++) {
      const flame = rootedFlame(this.world, index)?.flame;
      if (this.#worlds.burnsAtFirst(index)) flame?.light();
      else flame?.extinguish();
    }
  }

  /** Names of the candles' wicks, the carried one's first. */
  get candleNames(): readonly string[] {
    const { first, wicks } = this.#scene;
    return [first?.name ?? "wick", ...wicks.map(({ name }) => name)];
  }

  setLit(isLit: boolean, index = 0): void {
    const flame = rootedFlame(this.world, index)?.flame;
    if (isLit ? flame?.light() : flame?.extinguish()) {
      this.reports.tell(() => this.onFlameChanged(index, isLit));
    }
  }

  /** Makes a change, and notes each candle that was lit or went out, and whether the first was put down or taken up. */
  #noting(change: () => void): void {
    const before = litFlames(this.world);
    const wasHeld = this.world.candle.isHeld;
    change();
    for (const [index, isLit] of litFlames(this.world).entries()) {
      if (isLit === (before[index] ?? false)) continue;
      this.reports.note(() => this.onFlameChanged(index, isLit));
    }
    const { isHeld } = this.world.candle;
    if (isHeld !== wasHeld) this.reports.note(() => this.onCandleMoved(isHeld));
  }

  /** To be followed by `reports.tell`. */
  #replace(world: World): void {
    this.#noting(() => {
      this.world = world;
      this.view.follow(this.#subject);
    });
  }

  /**
   * Another scene on the same canvas, and its options. The old one is no longer used.
   *
   * @param isSameSource whether it is of the same `src`, for another look
   * @param isLit whether the first candle is to burn, if the page has said so since
   * @returns whether it is of the same room, and all has stayed where it was
   */
  show(scene: Scene, options: Options, isSameSource: boolean, isLit: boolean | null): boolean {
    this.#scene = scene;
    this.#options = options;
    const { candle, flame } = this.world;
    const next = this.#worlds;
    const isKept = isSameSource && next.isRoomOf(this.world);
    const burns = isLit ?? (isSameSource ? flame.isLit : null);
    this.world = isKept ? next.inLook(this.world) : next.inScene(this.world, burns);
    this.view.show(scene, options, this.#subject);
    const { isLit: burnsNow } = this.world.flame;
    const { isHeld } = this.world.candle;
    if (burnsNow !== flame.isLit) this.reports.note(() => this.onFlameChanged(0, burnsNow));
    if (isHeld !== candle.isHeld) this.reports.note(() => this.onCandleMoved(isHeld));
    this.reports.tell();
    return isKept;
  }

  /** Takes over the time, the camera and the candles of another, as far as the room here allows. */
  mirror({ world }: CandleFlame): void {
    this.#replace(this.#worlds.mirror(world, this.world));
    this.reports.tell();
  }

  /** Continues another world, with the first candle lit or not; in another room, from that room's start. */
  resume(before: World, isLit: boolean, isSameRoom: boolean): void {
    const next = this.#worlds;
    this.world = isSameRoom ? next.inLook(before, isLit) : next.inScene(before, isLit);
    this.view.follow(this.#subject);
  }

  /** Follows a change of one of the features that it was created with. */
  followFeature(name: keyof Features): void {
    if (name === "drift") this.view.follow(this.#subject);
  }

  get currentTime(): number {
    return currentTime(this.world);
  }

  /** Time 0, as if new: without what keys have asked for. */
  reset(): void {
    this.#restart();
    this.reports.tell();
  }

  #restart(): void {
    this.input?.read();
    this.#replace(this.#worlds.first());
  }

  /** One frame. Tests and the bench come here. */
  step(seconds: number): void {
    this.#advance(seconds, () => this.draw());
  }

  #advance(seconds: number, draw: () => void): void {
    const intent = this.input?.read() ?? STILL;
    const begin = performance.now();
    this.#noting(() => advance(this.world, intent, seconds));
    draw();
    this.#cpuMs = performance.now() - begin;
    this.reports.tell();
    if (this.input?.isIn) {
      const wick = wickAtFlame(this.world);
      if (wick > 0 && wick !== this.#wick) this.onWickReached(wick);
      this.#wick = wick;
    }
    if (intent.placesOrTakes) this.onRefused();
  }

  /** Draws the current state; unless it is required, not while a renderer is prepared. */
  draw(isRequired?: boolean): void {
    const canDefer = this.#loop.isRunning;
    const isMoving = this.#hasMoved() && canDefer;
    this.view.render({ ...this.#frameSettings, isMoving, canDefer }, isRequired);
  }

  /**
   * Draws what `draw` keeps for further frames, in small tasks, with a new renderer. Meanwhile the loop draws nothing.
   *
   * @param plays whether frames follow each other
   * @param isWanted whether it still is
   */
  prepareFrame(plays: boolean, isWanted: () => boolean): Promise<void> {
    return this.view.prepareFrame({ ...this.#frameSettings, canDefer: plays }, isWanted);
  }

  get #frameSettings() {
    const { exposure, isStill } = this.#options;
    return { features: this.#features, exposure, isStill, isMoving: false, canDefer: false };
  }

  /** Whether camera or candle have moved since the last call; a hand comes to rest within a tenth of a millimetre. */
  #hasMoved(): boolean {
    const { interpolated, fieldOfView } = this.world;
    const { eye, yaw, pitch, candleYaw } = interpolated;
    const foot = interpolated.foot.map((x) => x.toFixed(4));
    const camera = [...eye, yaw, pitch, fieldOfView];
    const before = this.#pose;
    this.#pose = `${[...camera, ...foot, candleYaw]}`;
    return this.#pose !== before;
  }

  play(): void {
    if (!this.#loop.isRunning) this.input?.read(); // what was asked for while time stood
    this.view.isPlaying = true;
    this.#loop.start();
  }

  pause(): void {
    this.view.isPlaying = false;
    this.#loop.stop();
  }

  /** @param elapsed milliseconds; NaN in the first frame */
  #frame(elapsed: number): void {
    try {
      this.view.measure(elapsed / 1000);
      const seconds = elapsed > 0 ? Math.min(elapsed / 1000, MAX_FRAME) : 0;
      this.#advance(seconds, () => !this.view.isBusy && this.draw());
    } catch (error) {
      this.#fail(error as Error);
      return;
    }
    this.onFrame();
  }

  #fail(error: Error): void {
    this.pause();
    this.onFailure(error);
  }

  get flame(): FlameReport {
    if (this.world.look === "physical") return flameReport(carriedFlame(this.world));
    const { position } = candleLight(this.world, this.#features, this.#options.isStill);
    return paperFlameReport(this.world, position);
  }

  /** The same of any candle; null where there is none. */
  reportOf(index: number): FlameReport | null {
    if (index === 0) return this.flame;
    const rooted = rootedFlame(this.world, index);
    return rooted && flameReport(rooted);
  }

  /** Of all candles, candela. */
  get luminousIntensity(): number {
    const reports = [this.flame, ...this.world.standing.map(flameReport)];
    return reports.reduce((sum, { luminousIntensity }) => sum + luminousIntensity, 0);
  }

  get stats(): Stats {
    const { particles, ...view } = this.view.stats;
    const frameMs = this.#loop.frameMs || 0;
    return {
      ...view,
      fps: frameMs > 0 ? 1000 / frameMs : 0,
      frameMs,
      cpuMs: this.#cpuMs,
      particles: this.#features.particles ? particles : 0,
    };
  }

  dispose(): void {
    this.pause();
    this.input?.dispose();
    this.view.dispose();
  }
}
