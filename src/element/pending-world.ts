import type { CandleFlame } from "../candle-flame.js";
import { areSame, type SceneRequest } from "../scenes/scene.js";
import { FIELDS_OF_VIEW, type Look } from "../settings.js";
import { isWithinReach } from "../world/candle.js";
import { placeCandle } from "../world/commands.js";
import { type Snapshot, takeSnapshot, timeOf } from "../world/snapshot.js";
import { cameraOf, setCamera } from "./camera.js";
import type { Camera } from "./element-types.js";

const ORIGIN = { position: [0, 0, 0], yaw: 0, pitch: 0, fieldOfView: null } as const;

/**
 * State of a world that does not exist yet, or not any more: the snapshot that it continues from, and the
 * camera and the placing that the page asked for meanwhile.
 */
export class PendingWorld {
  #camera: Partial<Camera> | null = null;
  /** Camera from which the candle is to be put down; null where it is to stay in the hand. */
  #placing: Partial<Camera> | null = null;
  /** Whether the page wants the first candle lit; null where attributes decide. */
  #isLit: boolean | null = null;
  /** With the scene that it was taken in. */
  #saved: { readonly snapshot: Snapshot; readonly request: SceneRequest } | null = null;

  /** @param look of the world to come, which has its own field of view */
  cameraFor(look: Look): Required<Camera> {
    const { position, yaw, pitch, fieldOfView } = this.#saved?.snapshot ?? ORIGIN;
    const saved = { position, yaw, pitch, fieldOfView: fieldOfView ?? FIELDS_OF_VIEW[look] };
    return structuredClone({ ...saved, ...this.#camera });
  }

  /** Request of the scene that the snapshot was taken in. */
  get request(): SceneRequest | null {
    return this.#saved?.request ?? null;
  }

  get currentTime(): number {
    return this.#saved ? timeOf(this.#saved.snapshot) : 0;
  }

  get isHeld(): boolean {
    return !this.#placing && !this.#saved?.snapshot.stand;
  }

  /** Null where attributes decide. */
  get isLit(): boolean | null {
    return this.#isLit ?? this.#saved?.snapshot.isLit ?? null;
  }

  /** Lights the first candle or puts it out, whatever the attributes say. */
  setLit(isLit: boolean): void {
    this.#isLit = isLit;
  }

  /**
   * Leaves it to the attributes which candles burn.
   *
   * @param isLit whether the first does
   */
  forgetFlames(isLit: boolean): void {
    this.#isLit = null;
    if (!this.#saved) return;
    const { request, snapshot } = this.#saved;
    this.save({ ...snapshot, areLit: null, isLit }, request);
  }

  save(snapshot: Snapshot, request: SceneRequest): void {
    this.#saved = { snapshot, request };
  }

  /** Drops the snapshot: the next world begins at time 0. */
  forgetTime(): void {
    this.#saved = null;
  }

  /** Drops all that the page has asked for. */
  forget(): void {
    this.forgetTime();
    this.forgetPlaces();
    this.#isLit = null;
  }

  moveCamera(camera: Partial<Camera>): void {
    this.#camera = { ...this.#camera, ...camera };
  }

  /** Has the candle put down from the current camera. */
  place(): void {
    if (!this.#saved?.snapshot.stand) this.#placing = { ...this.#camera };
  }

  /** Has the candle held. Returns whether it stands in the snapshot, within reach of the camera, and not fixed. */
  take(): boolean {
    this.#placing = null;
    if (!this.#saved?.snapshot.stand) return false;
    const { snapshot, request } = this.#saved;
    const { scene, look } = request;
    const isFixed = scene === "candle" || look === "original";
    if (isFixed || !isWithinReach(this.#saved.snapshot.stand, this.cameraFor(look))) return false;
    this.save({ ...snapshot, stand: null }, request);
    return true;
  }

  /** Drops camera, placing and flame: no other world follows, or it has them already. */
  forgetPlaces(): void {
    this.#camera = this.#placing = this.#isLit = null;
  }

  /**
   * Applies all of it to the new world; positions of the snapshot only in its own room.
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
    const isOther = this.#saved !== null || (isLit !== null && isLit !== candle.isLit(0));
    const isAny = isOther || this.#placing !== null || this.#camera !== null;
    if (isOther) {
      const snapshot = this.#saved?.snapshot ?? takeSnapshot(candle.world);
      const isSameRoom = !this.#saved || areSame(this.#saved.request, shownRequest);
      candle.resume({ ...snapshot, isLit: isLit ?? snapshot.isLit }, isSameRoom);
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
