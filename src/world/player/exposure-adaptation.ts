import { length3, type Vec3 } from "../geometry.js";
import type { CollisionMesh } from "../room/collision-mesh.js";
import type { World } from "../world.js";

/**
 * Auto exposure, in stops; 0 shows 1 cd/m² as the display's white.
 *
 * A frame whose mean luminance (logarithmic, the flame left out) is `luminance` is exposed by `stops`.
 * One that is twice as bright gets `share` of a stop less, so that bright stays brighter than dark. It
 * is never exposed by more than `most`: the eye has its limit, and a dark corner stays dark.
 */
export const EXPOSURE_LAW = {
  luminance: 0.011,
  stops: Math.log2(8.2),
  share: 0.95,
  least: -7,
  most: Math.log2(9.7),
  /** Of the room that this is tuned for, the cabin; twice as much raises the key by `keyShare` stops. */
  reflectance: 0.315,
  keyShare: 0.76,
} as const;

/** Least luminance that counts, cd/m². */
export const DARKEST = 1e-4;

/** Stops by which the largest exposure in moonlight exceeds `most`. */
const NIGHT_STOPS = 3.2;

/**
 * Largest exposure, stops.
 *
 * @param darkness adaptation to moonlight, 0 to 1
 */
export function mostExposure(darkness: number): number {
  return EXPOSURE_LAW.most + NIGHT_STOPS * darkness;
}

/** Exposure, stops, of a frame whose mean luminance is 2^meanStops cd/m². */
export function exposureOf(meanStops: number, darkness = 0): number {
  const { luminance, stops, share, least } = EXPOSURE_LAW;
  const wanted = stops - share * (meanStops - Math.log2(luminance));
  return Math.min(Math.max(wanted, least), mostExposure(darkness));
}

/** Time constants of adaptation to brighter and to darker, seconds: nine tenths take 2.1 and 3.5 s. */
const CLOSING = 0.9;
const OPENING = 1.5;

/** Adaptation to the dark, which takes minutes in nature, seconds; and its loss to a flame: a time constant. */
const DARKENING = 20;
const DAZZLING = 0.9;
/** Intensity below which all flames count as out, candela. */
const OUT = 1e-3;

/** Middle of a flame from its foot, metres. */
const MIDDLE = 0.025;
/** How much brighter than the carried flame, which is near, another one has to be. */
const BRIGHTER = 2;

/** Rays across a view of 16:9. */
const COLUMNS = 6;
const ROWS = 4;
const RAYS = COLUMNS * ROWS;
const ASPECT = 16 / 9;
const REACH = 40;
/** Of any surface. */
const ALBEDO = 0.28;
/** Smaller motions, metres or radians, do not change the view. */
const TOLERANCE = 1e-3;

/**
 * Exposure adaptation of the eye: how far it lags behind the exposure that the view asks for.
 *
 * The exposure is metered on the GPU, from the frame. The eye takes seconds to adapt. This lag is a part of the
 * world, so it is independent of the frame rate and survives a lost context. A few rays estimate the luminance;
 * only its changes matter, so the estimate may be coarse.
 */
export class ExposureAdaptation {
  /** Stops by which the eye is open wider than the view asks for. */
  lag = 0;
  /** Adaptation to moonlight, 0 to 1. Stays 0 in a room without moonlight. */
  darkness = 0;
  readonly #collision: CollisionMesh;
  /** Indirect light, lux for each candela. */
  readonly #bounced: number;
  #target = 0;
  /** Exposure that the last view asks for, stops. */
  #metered = 0;
  /** Luminances at the rays' ends, cd/m² for each candela of the flame. */
  readonly #luminances = new Float64Array(RAYS);
  /** View of those, and the current one: eye, yaw, pitch, middle of the flame, field of view. */
  readonly #lastView = new Float64Array(9).fill(Number.NaN);
  readonly #view = new Float64Array(9);
  /** Candle that the estimate goes by. */
  #candle = 0;
  readonly #flame: Vec3 = [0, 0, 0];
  readonly #direction: Vec3 = [0, 0, 0];
  readonly #place: Vec3 = [0, 0, 0];

  constructor(collision: CollisionMesh) {
    this.#collision = collision;
    // As in an integrating sphere.
    const { min, max } = collision.bounds;
    const x = max[0] - min[0];
    const y = max[1] - min[1];
    const z = max[2] - min[2];
    const area = 2 * (x * y + y * z + z * x);
    this.#bounced = ((4 * Math.PI) / area) * (ALBEDO / (1 - ALBEDO));
  }

  /** Exposure by the eye's own estimate, stops. */
  get exposure(): number {
    return this.#target + this.lag;
  }

  /** Adapts fully, to the dark as well: in a new world. */
  adaptFully(world: World): void {
    this.darkness = isMoonlit(world) ? 1 : 0;
    this.settle(world);
  }

  /** After a cut: the eye is adapted. */
  settle(world: World): void {
    this.#meter(world);
    this.#target = this.#metered;
    this.lag = 0;
  }

  /** After a sudden change of the view: the eye lags. */
  notice(world: World): void {
    const before = this.#candle;
    this.#meter(world);
    // By another candle's light the estimate is another one, and the view is not.
    if (before === this.#candle) this.lag += this.#target - this.#metered;
    this.#target = this.#metered;
  }

  advance(world: World, seconds: number): void {
    this.darkness = isMoonlit(world)
      ? Math.min(this.darkness + seconds / DARKENING, 1)
      : this.darkness * Math.exp(-seconds / DAZZLING);
    this.notice(world);
    this.lag *= Math.exp(-seconds / (this.lag > 0 ? CLOSING : OPENING));
  }

  #meter(world: World): void {
    const { candle, place, glow } = brightestRoot(world);
    this.#candle = candle;
    for (let axis = 0; axis < 3; axis++) this.#flame[axis] = place[axis]!;
    this.#flame[1] += MIDDLE;
    if (this.#hasMoved(world)) this.#castRays(world.player.position);
    let sum = 0;
    for (let ray = 0; ray < RAYS; ray++) {
      sum += Math.log2(Math.max(this.#luminances[ray]! * glow, DARKEST));
    }
    this.#metered = exposureOf(sum / RAYS, this.darkness);
  }

  #hasMoved({ player, fieldOfView, setup }: World): boolean {
    const view = this.#view;
    for (let axis = 0; axis < 3; axis++) {
      view[axis] = player.position[axis]!;
      view[axis + 5] = this.#flame[axis]!;
    }
    view[3] = player.yaw;
    view[4] = player.pitch;
    // Chosen by branches: as the value of an expression that may be null, a number is boxed.
    if (fieldOfView === null) view[8] = setup.fieldOfView;
    else view[8] = fieldOfView;
    let most = 0;
    for (let i = 0; i < view.length; i++) {
      most = Math.max(most, Math.abs(view[i]! - this.#lastView[i]!));
    }
    if (most < TOLERANCE) return false; // the first time it is NaN
    this.#lastView.set(view);
    return true;
  }

  #castRays(eye: Readonly<Vec3>): void {
    const view = this.#view;
    const height = Math.tan(view[8]! / 2);
    const sinYaw = Math.sin(view[3]!);
    const cosYaw = Math.cos(view[3]!);
    const sinPitch = Math.sin(view[4]!);
    const cosPitch = Math.cos(view[4]!);
    for (let ray = 0; ray < RAYS; ray++) {
      const right = (((ray % COLUMNS) + 0.5) * (2 / COLUMNS) - 1) * height * ASPECT;
      const up = ((Math.floor(ray / COLUMNS) + 0.5) * (2 / ROWS) - 1) * height;
      const ahead = cosPitch - up * sinPitch;
      const length = length3(right, up, 1);
      this.#direction[0] = (right * cosYaw - ahead * sinYaw) / length;
      this.#direction[1] = (sinPitch + up * cosPitch) / length;
      this.#direction[2] = (-right * sinYaw - ahead * cosYaw) / length;
      this.#lightRay(ray, eye);
    }
  }

  /** Luminance at a ray's end by a flame of 1 cd. */
  #lightRay(ray: number, eye: Readonly<Vec3>): void {
    const collision = this.#collision;
    const flame = this.#flame;
    const direction = this.#direction;
    const place = this.#place;
    const hit = collision.raycast(eye, direction, REACH);
    this.#luminances[ray] = hit ? (this.#bounced * ALBEDO) / Math.PI : 0;
    if (!hit) return;
    let squared = 0;
    let cosine = 0;
    for (let axis = 0; axis < 3; axis++) {
      // A little before the surface, so that it does not shadow itself.
      place[axis] = eye[axis]! + direction[axis]! * (hit.distance - 2e-3);
      const way = flame[axis]! - place[axis]!;
      squared += way * way;
      cosine += way * hit.normal[axis]!;
    }
    const distance = Math.sqrt(squared);
    cosine /= distance;
    if (!(cosine > 0)) return;
    if (!collision.isClear(place, flame)) return;
    this.#luminances[ray]! += ((cosine / squared) * ALBEDO) / Math.PI;
  }
}

function isMoonlit(world: World): boolean {
  return world.moon !== null && world.moon.illuminance > 0 && brightestRoot(world).glow < OUT;
}

const brightest: { candle: number; place: Readonly<Vec3>; glow: number } = {
  candle: 0,
  place: [0, 0, 0],
  glow: 0,
};

/** Root of the carried flame, or of a brighter one. */
function brightestRoot({ flame, emitter, standing }: World): typeof brightest {
  brightest.candle = 0;
  brightest.place = emitter;
  brightest.glow = flame.glow;
  let most = flame.glow * BRIGHTER;
  for (let i = 0; i < standing.length; i++) {
    const candle = standing[i]!;
    if (!(candle.flame.glow > most)) continue;
    most = candle.flame.glow;
    brightest.candle = i + 1;
    brightest.place = candle.root;
    brightest.glow = most;
  }
  return brightest;
}
