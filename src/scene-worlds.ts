import type { Scene } from "./scenes/scene.js";
import type { Look, Quality } from "./settings.js";
import type { Wind } from "./world/air/air.js";
import { moveCamera, standCandle, standLike } from "./world/commands.js";
import { createWorldInSteps, type WorldOptions } from "./world/create-world.js";
import { TAPER_WICK } from "./world/flame/burning.js";
import { litFlames } from "./world/flames.js";
import { type Moon, type MoonWish, moonOf } from "./world/moon.js";
import { finish, type Steps } from "./world/steps.js";
import type { Stand, World } from "./world/world.js";
import { LONE_CANDLE_SETUP } from "./world/world-setup.js";

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
  /** Diameter of the first candle's wick, metres; null: the model's own. */
  readonly wick: number | null;
  readonly unlit: boolean;
  readonly moon: MoonWish;
  /** Candles that burn at first, unless `unlit`; null: the carried one in a room, all of a model alone. */
  readonly litWicks: readonly number[] | null;
  /** No flicker and no sway: `prefers-reduced-motion`. */
  readonly isStill: boolean;
}

/** Worlds of a scene: new ones, and such as take over what another one had. */
export class SceneWorlds {
  readonly #scene: Scene;
  readonly #options: Options;

  constructor(scene: Scene, options: Options) {
    this.#scene = scene;
    this.#options = options;
  }

  burnsAtFirst(index: number): boolean {
    const { unlit, litWicks } = this.#options;
    return !unlit && (litWicks?.includes(index) ?? (this.#scene.isModelAlone || index === 0));
  }

  /** Null where none shines. */
  get moon(): Moon | null {
    const { look, moon } = this.#options;
    return look === "physical" ? moonOf(moon, this.#scene.moonDirection) : null;
  }

  /** Diameter of the first candle's wick, metres. */
  get wick(): number {
    return this.#options.wick ?? this.#scene.first?.wickDiameter ?? TAPER_WICK;
  }

  /** A new one. */
  first(birth?: WorldOptions): World {
    return finish(this.firstInSteps(birth));
  }

  /** The same in steps of a few milliseconds. */
  *firstInSteps(birth: WorldOptions = {}): Steps<World> {
    const { room, wicks, createPlume, createSample, isModelAlone, first } = this.#scene;
    const { seed, isStill, wind } = this.#options;
    // A model alone burns the same in any look.
    const look = isModelAlone ? "physical" : this.#options.look;
    const alone = first ? { ...LONE_CANDLE_SETUP, wick: first.position } : LONE_CANDLE_SETUP;
    return yield* createWorldInSteps(look, seed, {
      createPlume,
      createSample,
      room,
      setup: isModelAlone ? alone : null,
      wind,
      wick: this.wick,
      wicks,
      moon: this.moon,
      isLit: this.burnsAtFirst(0),
      areLit: wicks.map((_, i) => this.burnsAtFirst(i + 1)),
      sways: !isStill,
      ...birth,
    });
  }

  /** At another's time, with the camera at its start. */
  #sameTimeAs({ timeline, remainder, flame, fieldOfView }: World, birth: WorldOptions = {}): World {
    const { isLit } = flame;
    const world = this.first({ age: timeline.tick, isLit, fieldOfView, ...birth });
    world.remainder = remainder;
    return world;
  }

  /**
   * After another scene's.
   *
   * @param isLit whether the first candle burns; null: as before, or, of a model alone, as the attributes say
   */
  inScene(before: World, isLit: boolean | null): World {
    const burns = this.#scene.isModelAlone ? this.burnsAtFirst(0) : before.flame.isLit;
    return this.#sameTimeAs(before, { isLit: isLit ?? burns });
  }

  /** Whether a world has the same room as the scene. */
  isRoomOf(before: World): boolean {
    const { room } = this.#scene;
    return room !== null && before.room?.isSame(room) === true;
  }

  /** In another look: the same time, and the camera in its place, or inside the new look's walls. */
  inLook(before: World, isLit = before.flame.isLit): World {
    const { setup, formerStand, candle } = before;
    const { position, yaw, pitch } = before.player;
    const stand: Stand | null = candle.isHeld ? null : structuredClone(candle);
    const world = this.#sameTimeAs(before, { isLit, areLit: this.#areLit(before) });
    world.formerLit = before.standing.length > 0 ? litFlames(before).slice(1) : before.formerLit;
    moveCamera(world, position, yaw, pitch);
    world.formerStand = setup.stand === null ? stand : formerStand;
    if (world.formerStand) standCandle(world, world.formerStand.position, world.formerStand.yaw);
    return world;
  }

  /** Which standing candles burn: those of the worlds before, the first of them that has such a candle. */
  #areLit(...before: readonly World[]): boolean[] {
    const lit = before.flatMap((world) => [litFlames(world).slice(1), world.formerLit]);
    return this.#scene.wicks.map((_, i) => {
      const known = lit.find((flames) => flames.length > i);
      return known?.[i] ?? this.burnsAtFirst(i + 1);
    });
  }

  /** With the time, the camera and the candles of another, as far as the room allows. */
  mirror(other: World, before: World): World {
    const { position, yaw, pitch } = other.player;
    const world = this.#sameTimeAs(other, { areLit: this.#areLit(other, before) });
    moveCamera(world, position, yaw, pitch);
    standLike(world, other);
    return world;
  }
}
