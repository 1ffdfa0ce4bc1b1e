import type { CandleFlame } from "../candle-flame.js";
import { areSame, type SceneRequest } from "../scenes/scene.js";
import { FIELDS_OF_VIEW, type Look } from "../settings.js";
import { fieldOfViewOf, legalFieldOfView } from "../world/field-of-view.js";
import { type Moment, timeOf } from "../world/moment.js";
import { moveCamera, placeCandle } from "../world/world.js";

export interface Camera {
  /** Metres; the origin is on the floor, amid the room. */
  readonly position: readonly [number, number, number];
  /** Radians, counter-clockwise from above; 0 looks along -Z. */
  readonly yaw: number;
  /** Radians, up positive. */
  readonly pitch: number;
  /** Radians across the picture's shorter side, 0.3 to 2.1; the look's own if it is not given. */
  readonly fieldOfView?: number;
}

const NOWHERE = { position: [0, 0, 0], yaw: 0, pitch: 0, fieldOfView: null } as const;

/**
 * What is known and wanted of a world while there is none to see: before the first one, while a room that
 * had to give way sleeps, and while another room is on its way.
 */
export class Absence {
  #camera: Partial<Camera> | null = null;
  /** From where the candle is to be put down; null where it is to stay in the hand. */
  #placing: Partial<Camera> | null = null;
  /** From where a room goes on, and which room that is. */
  #asleep: { readonly moment: Moment; readonly of: SceneRequest } | null = null;

  /** @param look that is to come, which has its own field of view */
  cameraFor(look: Look): Required<Camera> {
    const { position, yaw, pitch, fieldOfView } = this.#asleep?.moment ?? NOWHERE;
    const own = { position, yaw, pitch, fieldOfView: fieldOfView ?? FIELDS_OF_VIEW[look] };
    return { ...own, ...this.#camera };
  }

  get currentTime(): number {
    return this.#asleep ? timeOf(this.#asleep.moment) : 0;
  }

  get isHeld(): boolean {
    return !this.#placing && !this.#asleep?.moment.stand;
  }

  /** Null where nothing has burnt yet. */
  get isLit(): boolean | null {
    return this.#asleep?.moment.isLit ?? null;
  }

  set isLit(isLit: boolean) {
    if (this.#asleep) this.#asleep = { ...this.#asleep, moment: { ...this.#asleep.moment, isLit } };
  }

  fallAsleep(moment: Moment, of: SceneRequest): void {
    this.#asleep = { moment, of };
  }

  /** Time is to begin anew. */
  forgetTime(): void {
    this.#asleep = null;
  }

  /** The camera of the world to come. */
  want(camera: Partial<Camera>): void {
    this.#camera = { ...this.#camera, ...camera };
  }

  /** The candle is to be put down from the camera that is wanted now. */
  place(): void {
    if (!this.#asleep?.moment.stand) this.#placing = { ...this.#camera };
  }

  /** It is to be in the hand. */
  take(): void {
    this.#placing = null;
  }

  /** No other world is to come. */
  forgetCamera(): void {
    this.#camera = null;
  }

  /**
   * The world is there: it goes on from where it was, as far as it is the same room, and as was wanted.
   *
   * @param onPlaced called when the candle has been put down, while the camera is where that was done
   */
  end(candle: CandleFlame, shown: SceneRequest | null, onPlaced: () => void): void {
    if (this.#asleep) candle.resume(this.#asleep.moment, areSame(this.#asleep.of, shown));
    if (this.#placing) {
      const before = cameraOf(candle);
      setCamera(candle, this.#placing);
      if (placeCandle(candle.world)) onPlaced();
      setCamera(candle, before);
    }
    if (this.#camera) setCamera(candle, this.#camera);
    this.#asleep = null;
    this.#placing = null;
    this.#camera = null;
  }
}

export function cameraOf({ world }: CandleFlame): Required<Camera> {
  const { position, yaw, pitch } = world.player;
  const [x, y, z] = position;
  return { position: [x, y, z], yaw, pitch, fieldOfView: fieldOfViewOf(world) };
}

/** What a camera is to change: a field of view that is as it is stays the look's own, if it was that. */
export function changeOf(camera: Partial<Camera>, before: Camera): Partial<Camera> {
  // A text, spread, would give an object of a million letters.
  const { fieldOfView, ...others } = typeof camera === "object" ? { ...camera } : {};
  const legal = legalFieldOfView(fieldOfView);
  return legal === null || legal === before.fieldOfView
    ? others
    : { ...others, fieldOfView: legal };
}

/** What is not given stays as it is; nonsense does, too. */
export function setCamera(candle: CandleFlame, camera: Partial<Camera>): void {
  const before = cameraOf(candle);
  const { position, yaw, pitch } = { ...before, ...camera };
  const place = position ?? before.position;
  moveCamera(candle.world, place, Number(yaw), Number(pitch), camera.fieldOfView);
}
