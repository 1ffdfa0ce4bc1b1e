import { burnsAtFirst, type Options, worldOf } from "./scene-world.js";
import type { Scene } from "./scenes/scene.js";
import { moveCamera, standCandle, standLike } from "./world/commands.js";
import type { WorldOptions } from "./world/create-world.js";
import { litFlames } from "./world/flames.js";
import type { Stand, World } from "./world/world.js";

/** New worlds of a scene, which take over what another one had. */
export class NextWorld {
  readonly #scene: Scene;
  readonly #options: Options;

  constructor(scene: Scene, options: Options) {
    this.#scene = scene;
    this.#options = options;
  }

  /** A new one. */
  first(birth: WorldOptions = {}): World {
    return worldOf(this.#scene, this.#options, birth);
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
    const { isModelAlone } = this.#scene;
    const burns = isModelAlone ? burnsAtFirst(0, this.#scene, this.#options) : before.flame.isLit;
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
      return known?.[i] ?? burnsAtFirst(i + 1, this.#scene, this.#options);
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
