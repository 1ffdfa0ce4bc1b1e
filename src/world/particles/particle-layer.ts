/** Slots of a layer come in this many groups, each of which takes every fourth birth. */
export const GROUPS = 4;

export type ParticleSource = "flame" | "spark" | "room";

/**
 * One row of the particle system: emission, motion, size and life of a kind of particle.
 *
 * Lengths are in the emitter's own unit (`WorldSetup.flameScale` metres), times in seconds.
 */
export interface ParticleLayer {
  readonly name: "core" | "haze" | "dust" | "spark";
  /** Emitter: the flame, the flame when it throws sparks, or the air of the room. */
  readonly source: ParticleSource;
  /** Slots. A multiple of `GROUPS`, and enough for `rate * life`. */
  readonly capacity: number;
  /** Births per second. */
  readonly rate: number;
  /** Half-width of the square of birth, around the emitter. */
  readonly spawnRadius: number;
  /** Height of birth above the emitter, and how much higher or lower it may be. */
  readonly spawnHeight: number;
  readonly spawnDepth: number;
  /** Upward speed at birth. */
  readonly speed: readonly [min: number, max: number];
  /** Largest sideways speed at birth. */
  readonly sideSpeed: number;
  /** Upward acceleration. */
  readonly buoyancy: number;
  /** Largest random sideways acceleration. */
  readonly drift: number;
  /** Rate at which the velocity nears the wind's, 1/s. */
  readonly drag: number;
  /** Share of the emitter's motion that a particle follows: 1 moves with it, 0 stays in the room. */
  readonly follow: number;
  readonly life: number;
  /** Diameter at birth. */
  readonly size: number;
}

/**
 * The same layers with `count` particles alive in all.
 *
 * The glowing area stays the same: more particles are smaller ones.
 */
export function withCount(
  layers: readonly ParticleLayer[],
  count: number,
): readonly ParticleLayer[] {
  const alive = layers.reduce((sum, { rate, life }) => sum + rate * life, 0);
  const factor = count / alive;
  return layers.map((layer) => ({
    ...layer,
    rate: layer.rate * factor,
    // One more than can be alive, so that a slot's particle is dead before the slot is reused.
    capacity: GROUPS * Math.ceil((layer.rate * factor * layer.life + 1) / GROUPS),
    size: layer.size / Math.sqrt(factor),
  }));
}

/** Shared by the layers of the paper's flame. */
const PAPER_FLAME = {
  source: "flame",
  spawnDepth: 0,
  sideSpeed: 0.05,
  buoyancy: 0.5,
  drift: 0.1,
  follow: 1,
} as const;

const PAPER_CORE: ParticleLayer = {
  ...PAPER_FLAME,
  name: "core",
  capacity: 500,
  rate: 300,
  spawnRadius: 0.01,
  spawnHeight: 0,
  speed: [1.0, 1.5],
  drag: 0.12,
  life: 0.7,
  size: 0.26,
};

/**
 * PAPER: "Dynamic Fire Effects Using OpenGL Rasterization Techniques", two layers.
 *
 * Counts, rates, speeds and lives are those of its published code; sizes in metres, the height of
 * birth and the drag to the wind are ours (DECISIONS.md, "The paper's flame is scaled to a candle").
 */
export const PAPER_LAYERS: readonly ParticleLayer[] = [
  {
    ...PAPER_FLAME,
    name: "haze",
    capacity: 300,
    rate: 100,
    spawnRadius: 0.05,
    spawnHeight: -0.02,
    speed: [0.5, 1.0],
    drag: 0.1,
    life: 1.5,
    size: 0.42,
  },
  PAPER_CORE,
];

/** The paper's "before": one layer, one speed, no drift. */
export const ORIGINAL_LAYERS: readonly ParticleLayer[] = [
  { ...PAPER_CORE, spawnRadius: 0.05, speed: [1, 1], buoyancy: 0, drift: 0, drag: 0, size: 0.06 },
];

/**
 * Dust and sparks of the physical look, in units of 3.5 cm: lint and dust of the room, carried by
 * its air, and burning wax that a wick throws when water in it boils. A mote is `size` wide, 0.06 mm; a
 * droplet 0.2 mm.
 */
export const PHYSICAL_LAYERS: readonly ParticleLayer[] = [
  {
    name: "dust",
    source: "room",
    capacity: 124,
    rate: 60,
    spawnRadius: 12,
    spawnHeight: 3,
    spawnDepth: 8,
    speed: [-0.3, 0.3],
    sideSpeed: 0.3,
    buoyancy: 0,
    drift: 0.8,
    drag: 1.5,
    follow: 0,
    life: 2,
    size: 0.0017,
  },
  {
    name: "spark",
    source: "spark",
    capacity: 72,
    rate: 150,
    spawnRadius: 0.04,
    spawnHeight: 0.15,
    spawnDepth: 0,
    speed: [8, 26],
    sideSpeed: 13,
    buoyancy: -110,
    drift: 250,
    drag: 2,
    follow: 0,
    life: 0.45,
    size: 0.006,
  },
];
