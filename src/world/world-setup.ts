import { FIELDS_OF_VIEW, type Look } from "../settings.js";
import type { Bounds } from "./geometry.js";
import {
  ORIGINAL_LAYERS,
  PAPER_LAYERS,
  type ParticleLayer,
  PHYSICAL_LAYERS,
} from "./particles/particle-layer.js";
import { RUN, WALK } from "./player/gait.js";
import type { Gait } from "./player/player.js";

/** Setup of the world for a look: the room's size, and how candle and flame stand in it. Metres. */
export interface WorldSetup {
  readonly room: Bounds;
  /** Whether walls stop the visitor. */
  readonly hasWalls: boolean;
  readonly gait: Gait;
  /** Initial position and direction of the eye. */
  readonly spawn: readonly [number, number, number];
  readonly yaw: number;
  readonly pitch: number;
  /** Across the frame's shorter side, radians. */
  readonly fieldOfView: number;
  /** Metres per unit of the candle's model, which is 1 high. */
  readonly candleScale: number;
  /** Metres per unit of the particle layers. */
  readonly flameScale: number;
  /** Foot of the flame, from the candle's, in units of the model. */
  readonly wick: readonly [number, number, number];
  /** Foot of the candle: from the eye when held (right, up, ahead), or in the room. */
  readonly hold: readonly [number, number, number];
  readonly stand: readonly [number, number, number] | null;
  /** Whether there are only candles, and no visitor. */
  readonly isAlone: boolean;
  readonly layers: readonly ParticleLayer[];
}

/** No wall comes nearer to the eye than this, in metres (the paper's number). */
export const WALL_MARGIN = 0.5;

// The box is 10 x 10 m as the paper's; its height is ours: a ceiling at 10 m would be night sky.
const PAPER: WorldSetup = {
  room: { min: [-5, 0, -5], max: [5, 3.2, 5] },
  hasWalls: true,
  gait: { walk: 2, run: 4 },
  spawn: [1.2, 1.6, 2.6],
  yaw: 0.35,
  pitch: 0,
  fieldOfView: FIELDS_OF_VIEW.paper,
  candleScale: 0.26,
  flameScale: 0.125,
  wick: [0.01, 1.03, 0.005],
  hold: [0.17, -0.4, 0.5],
  stand: null,
  isAlone: false,
  layers: PAPER_LAYERS,
};

export const WORLD_SETUPS: Readonly<Record<Look, WorldSetup>> = {
  // The room is whatever model is loaded; the hold is low and to the side, so that shadows open away.
  physical: {
    ...PAPER,
    gait: { walk: WALK, run: RUN },
    pitch: -0.08,
    fieldOfView: FIELDS_OF_VIEW.physical,
    candleScale: 1,
    flameScale: 0.035,
    wick: [0.0011, 0.2, 0.0003],
    hold: [0.24, -0.34, 0.56],
    layers: PHYSICAL_LAYERS,
  },
  paper: PAPER,
  original: {
    ...PAPER,
    hasWalls: false,
    candleScale: 1,
    flameScale: 0.5,
    stand: [0, 0, 0],
    layers: ORIGINAL_LAYERS,
  },
};

/** The candle alone on bare ground, whatever the look. */
export const LONE_CANDLE_SETUP: WorldSetup = {
  ...WORLD_SETUPS.physical,
  hasWalls: false,
  yaw: 0,
  // As its model is turned, whose handle is at the right.
  wick: [0, 0.2, 0.001],
  stand: [0, 0, 0],
  isAlone: true,
};
