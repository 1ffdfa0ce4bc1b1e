import type { Look } from "../settings.js";
import type { Air } from "./air/air.js";
import type { CreatePlume, Plume } from "./air/plume.js";
import type { Candle } from "./candle.js";
import type { Flame } from "./flame/flame.js";
import type { Vec3 } from "./geometry.js";
import type { Moon } from "./moon.js";
import type { Particles } from "./particles/particles.js";
import type { ExposureAdaptation } from "./player/exposure-adaptation.js";
import type { Hand } from "./player/hand.js";
import type { Lead, Player } from "./player/player.js";
import type { MovementBounds } from "./room/movement-bounds.js";
import type { Refusal } from "./room/placement.js";
import type { Room } from "./room/room.js";
import type { StandingCandle } from "./standing-candle.js";
import { TICK, type Timeline } from "./timeline.js";
import type { WorldSetup } from "./world-setup.js";

/**
 * State of the simulation. Independent of screen, GPU and clock.
 *
 * `createWorld` makes one, `advance` lets time pass, the functions of `commands.ts` act on it.
 */
export interface World {
  /** `physical` for a model alone, whatever the attribute. */
  readonly look: Look;
  readonly setup: WorldSetup;
  readonly seed: number;
  /** Null in the paper's box, which `setup` describes. */
  readonly room: Room | null;
  readonly movementBounds: MovementBounds;
  readonly player: Player;
  readonly hand: Hand;
  readonly candle: Candle;
  /** Candles of the room's model, in the order of its nodes; none in the paper's looks. */
  readonly standing: readonly StandingCandle[];
  readonly air: Air;
  readonly flame: Flame;
  /** Hot air and smoke; null where `createPlume` is, and on a page unless there is smoke. */
  plume: Plume | null;
  /** Null where neither is drawn: the paper's flame heats nothing. */
  readonly createPlume: CreatePlume | null;
  /** Null where there is no room in real light. */
  readonly adaptation: ExposureAdaptation | null;
  /** Foot of the flame, metres. */
  readonly emitter: Vec3;
  /** What is drawn: the moment of the frame, up to a tick after the state above. */
  readonly interpolated: Interpolated;
  /** Turning by keys or stick since the last tick, which the view shows and no tick has had yet. */
  readonly lead: Lead;
  readonly timeline: Timeline;
  /** Every fourth particle of the paper's brightest layer: their centre is that of the light. Null in the physical look. */
  readonly sample: Particles | null;
  /** Time asked for and not yet simulated, seconds, less than a tick. */
  remainder: number;
  /** Phase of the stride, 0 to 1. */
  stride: number;
  /** Across the frame's shorter side, radians, as the page wants it; null is the setup's. */
  fieldOfView: number | null;
  /** Whether walking sways the head, and air the flame. */
  sways: boolean;
  /** Why the candle could not be put down or taken up when that was last tried; null if it could. */
  refusal: Refusal | null;
  /** Null where it does not shine. */
  moon: Moon | null;
  /** Where the candle stood before a look that stands it elsewhere; null if it was held. */
  formerStand: Stand | null;
  /** Which standing candles burned before a look that has none. */
  formerLit: readonly boolean[];
}

/** Metres and radians. */
export interface Interpolated {
  readonly eye: Vec3;
  yaw: number;
  pitch: number;
  /** Of the carried candle, and the way it is turned. */
  readonly foot: Vec3;
  readonly flame: Vec3;
  candleYaw: number;
}

/** Place of a candle that was put down, and how it is turned. */
export interface Stand {
  readonly position: Readonly<Vec3>;
  readonly yaw: number;
}

/** Field of view across the frame's shorter side, radians. */
export function fieldOfViewOf({ fieldOfView, setup }: World): number {
  return fieldOfView ?? setup.fieldOfView;
}

/** Seconds simulated since the beginning. */
export function currentTime({ timeline, remainder }: World): number {
  return timeline.tick * TICK + remainder;
}
