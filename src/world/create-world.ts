import type { Look } from "../settings.js";
import { Air, CALM, type Wind } from "./air/air.js";
import type { CreatePlume } from "./air/plume.js";
import { TAPER_WICK } from "./flame/burning.js";
import { Flame } from "./flame/flame.js";
import { inset, type Vec3 } from "./geometry.js";
import type { Moon } from "./moon.js";
import type { CreateSample } from "./particles/particles.js";
import { createHand } from "./player/hand.js";
import { boxBounds, UNBOUNDED } from "./room/movement-bounds.js";
import type { Room } from "./room/room.js";
import { createStandingCandle, type Wick } from "./standing-candle.js";
import type { Steps } from "./steps.js";
import { HISTORY, Timeline } from "./timeline.js";
import { warmUp } from "./warm-up.js";
import type { World } from "./world.js";
import { WALL_MARGIN, WORLD_SETUPS, type WorldSetup } from "./world-setup.js";

/** Strongest wind that one can light a candle in, m/s. */
const LIGHTABLE = 1;

export interface WorldOptions {
  /** Ticks that count as simulated, for a world that takes over from another. */
  readonly age?: number;
  readonly room?: Room | null;
  /** Makes hot air and smoke; without it there is none. */
  readonly createPlume?: CreatePlume | null;
  /** Needed by the paper's looks. */
  readonly createSample?: CreateSample | null;
  /** Default: the look's. */
  readonly setup?: WorldSetup | null;
  readonly wind?: Wind;
  /** Diameter of the wick, metres. */
  readonly wick?: number;
  readonly isLit?: boolean;
  /** Of standing candles, which the paper's looks have none of; and whether each burns, by default none. */
  readonly wicks?: readonly Wick[];
  readonly areLit?: readonly boolean[];
  readonly moon?: Moon | null;
  readonly fieldOfView?: number | null;
  /** `World`'s. Default: they do. */
  readonly sways?: boolean;
}

/** A new world, whose flame is fully developed, in steps of a few milliseconds. */
export function* createWorldInSteps(
  look: Look,
  seed: number,
  options: WorldOptions = {},
): Steps<World> {
  const { age = 0, room = null, wind = CALM, wick = TAPER_WICK, isLit = true } = options;
  const setup = options.setup ?? WORLD_SETUPS[look];
  const { yaw, start } = room ?? { yaw: setup.yaw, start: setup.spawn };
  const eye: Vec3 = [...start];
  const { pitch } = setup;
  const box = setup.hasWalls ? boxBounds(inset(setup.room, WALL_MARGIN)) : UNBOUNDED;
  const { wicks = [], areLit = [] } = options;
  const isPhysical = look === "physical";
  const standing = (isPhysical ? wicks : []).map((wick, i) =>
    createStandingCandle(wick, i + 1, seed, areLit[i] ?? false),
  );
  const world: World = {
    look,
    setup,
    seed,
    room,
    movementBounds: room?.movementBounds ?? box,
    player: { position: eye, velocity: [0, 0, 0], yaw, pitch },
    hand: createHand(yaw),
    candle: { position: [...(setup.stand ?? eye)], yaw, isHeld: setup.stand === null },
    standing,
    air: new Air(seed, { ...wind, speed: Math.min(wind.speed, LIGHTABLE) }),
    flame: new Flame(wick, isLit),
    plume: null,
    createPlume: isPhysical ? (options.createPlume ?? null) : null,
    adaptation: isPhysical && room ? room.createAdaptation() : null,
    emitter: [0, 0, 0],
    interpolated: { eye: [0, 0, 0], yaw, pitch, foot: [0, 0, 0], flame: [0, 0, 0], candleYaw: yaw },
    lead: { turn: 0, tilt: 0 },
    timeline: new Timeline(age - HISTORY),
    sample: isPhysical ? null : (options.createSample?.(setup.layers, seed) ?? null),
    remainder: 0,
    stride: 0,
    fieldOfView: options.fieldOfView ?? null,
    sways: options.sways ?? true,
    refusal: null,
    moon: options.moon ?? null,
    formerStand: null,
    formerLit: [],
  };
  room?.plan.setObstacle(null);
  yield* warmUp(world, wind);
  return world;
}
