import type { CandleFlame } from "../candle-flame.js";
import { areSame, type SceneRequest } from "../scenes/scene.js";
import { FIELDS_OF_VIEW, type Look } from "../settings.js";
import { isWithinReach } from "../world/candle.js";
import { placeCandle } from "../world/commands.js";
import { UNBOUNDED } from "../world/room/movement-bounds.js";
import { currentTime, type World } from "../world/world.js";
import { cameraOf, setCamera } from "./camera.js";
import type { Camera } from "./element-types.js";

const ORIGIN = { player: { position: [0, 0, 0], yaw: 0, pitch: 0 }, fieldOfView: null } as const;

/**
 * State of a world that does not exist yet, or not any more: the one that it continues, and the camera and the placing
 * that the page asked for meanwhile.
 */
export class PendingWorld {
  #camera: Partial<Camera> | null = null;
  /** Camera from which the candle is to be put down; null where it is to stay in the hand. */
  #placing: Partial<Camera> | null = null;
  /** Whether the page wants the first candle lit; null where attributes decide. */
  #isLit: boolean | null = null;
  /** The same, of the worlds after a removal. */
  #wasSetLit: boolean | null = null;
  /** A world that is gone, and the request of its scene. */
  #saved: { readonly world: World; readonly request: SceneRequest } | null = null;

  /** @param look of the world to come, which has its own field of view */
  cameraFor(look: Look): Required<Camera> {
    const { player, fieldOfView } = this.#saved?.world ?? ORIGIN;
    const { position, yaw, pitch } = player;
    const saved = { position, yaw, pitch, fieldOfView: fieldOfView ?? FIELDS_OF_VIEW[look] };
    return structuredClone({ ...saved, ...this.#camera });
  }

  /** Request of the scene that the saved world was of. */
  get request(): SceneRequest | null {
    return this.#saved?.request ?? null;
  }

  get currentTime(): number {
    return this.#saved ? currentTime(this.#saved.world) : 0;
  }

  get isHeld(): boolean {
    return !this.#placing && (this.#saved?.world.candle.isHeld ?? true);
  }

  /** Null where attributes decide. */
  get isLit(): boolean | null {
    return this.#isLit ?? this.#saved?.world.flame.isLit ?? null;
  }

  /**
   * Lights the first candle or puts it out, whatever the attributes say.
   *
   * @param isNow whether the world has none yet; else only after a removal
   */
  setLit(isLit: boolean, isNow: boolean): void {
    this.#wasSetLit = isLit;
    if (isNow) this.#isLit = isLit;
  }

  /**
   * Leaves it to the attributes which candles burn.
   *
   * @param isLit whether the first does
   */
  forgetFlames(isLit: boolean): void {
    const saved = this.#saved;
    this.#wasSetLit = null;
    this.#isLit = saved && isLit;
    this.#saved = saved && { ...saved, world: { ...saved.world, standing: [], formerLit: [] } };
  }

  /** The world that the next one goes on from, without what needs much memory. */
  save(world: World, request: SceneRequest): void {
    const standing = world.standing.map((one) => ({ ...one, plume: null }));
    const kept = { room: null, movementBounds: UNBOUNDED, standing, plume: null, adaptation: null };
    this.#saved = { world: { ...world, ...kept }, request };
  }

  /** Drops the saved world: the next world begins at time 0. */
  forgetTime(): void {
    this.#saved = null;
  }

  /** Drops all that the page has asked for. */
  forget(): void {
    this.forgetTime();
    this.forgetPlaces();
    this.#wasSetLit = null;
  }

  /** The element was removed: only what the page has set is left of its worlds. */
  leave(): void {
    this.forgetTime();
    this.#isLit = this.#wasSetLit;
  }

  moveCamera(camera: Partial<Camera>): void {
    this.#camera = { ...this.#camera, ...camera };
  }

  /** Has the candle put down from the current camera. */
  place(): void {
    if (this.#saved?.world.candle.isHeld !== false) this.#placing = { ...this.#camera };
  }

  /** Has the candle held. Returns whether it stood in the saved world, within reach of the camera, and not fixed. */
  take(): boolean {
    this.#placing = null;
    if (!this.#saved) return false;
    const { candle, setup } = this.#saved.world;
    if (candle.isHeld || setup.stand) return false;
    candle.isHeld = isWithinReach(candle, this.cameraFor(this.#saved.request.look));
    return candle.isHeld;
  }

  /** Drops camera, placing and flame: no other world follows, or it has them already. */
  forgetPlaces(): void {
    this.#camera = this.#placing = this.#isLit = null;
  }

  /**
   * Applies all of it to the new world; places of the saved one only in its own room.
   *
   * @param isFollowed whether another world is on its way, for which camera and placing are kept
   * @param onPlaced called when the candle has been put down, with the camera that it was put down from; without it
   * all is kept, to be applied again
   * @returns whether there was anything
   */
  applyTo(
    candle: CandleFlame,
    shownRequest: SceneRequest | null,
    isFollowed: boolean,
    onPlaced?: () => void,
  ): boolean {
    const isLit = this.#isLit;
    const isOther = this.#saved !== null || (isLit !== null && isLit !== candle.world.flame.isLit);
    const isAny = isOther || this.#placing !== null || this.#camera !== null;
    if (isOther) {
      const { world } = this.#saved ?? candle;
      const isSameRoom = !this.#saved || areSame(this.#saved.request, shownRequest);
      candle.resume(world, isLit ?? world.flame.isLit, isSameRoom);
    }
    if (this.#placing) {
      const before = cameraOf(candle);
      setCamera(candle, this.#placing);
      if (placeCandle(candle.world)) onPlaced?.();
      setCamera(candle, before);
    }
    if (this.#camera) setCamera(candle, this.#camera);
    if (!onPlaced) return isAny;
    this.forgetTime();
    if (shownRequest?.scene !== "candle") this.#isLit = null; // the next room's is as this one's
    if (!isFollowed) this.forgetPlaces();
    return isAny;
  }
}
