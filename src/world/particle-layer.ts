/** Slots of a layer come in this many groups, each of which takes every fourth birth. */
export const GROUPS = 4;

/**
 * One row of the particle system: how a kind of particle is born, moves, looks and dies.
 *
 * Lengths are in the emitter's own unit (`Stage.flameScale` metres), times in seconds.
 */
export interface ParticleLayer {
  readonly name: "core" | "haze";
  /** Slots. A multiple of `GROUPS`, and enough for `rate * life`. */
  readonly capacity: number;
  /** Births per second. */
  readonly rate: number;
  /** Half-width of the square of birth, around the emitter. */
  readonly spawnRadius: number;
  /** Height of birth above the emitter. */
  readonly spawnHeight: number;
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
  /** How much of the emitter's own way a particle shares: 1 rides with it, 0 stays in the room. */
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
    // One more than can be alive, so that a slot's last tenant is gone when the next one moves in.
    capacity: GROUPS * Math.ceil((layer.rate * factor * layer.life + 1) / GROUPS),
    size: layer.size / Math.sqrt(factor),
  }));
}

/**
 * PAPER: "Dynamic Fire Effects Using OpenGL Rasterization Techniques", two layers.
 *
 * Counts, rates, speeds and lives are those of its published code; sizes in metres, the height of
 * birth and the drag to the wind are ours (DECISIONS.md, "A flame on the wick").
 */
export const PAPER_LAYERS: readonly ParticleLayer[] = [
  {
    name: "haze",
    capacity: 300,
    rate: 100,
    spawnRadius: 0.05,
    spawnHeight: -0.02,
    speed: [0.5, 1.0],
    sideSpeed: 0.05,
    buoyancy: 0.5,
    drift: 0.1,
    drag: 0.1,
    follow: 1,
    life: 1.5,
    size: 0.42,
  },
  {
    name: "core",
    capacity: 500,
    rate: 300,
    spawnRadius: 0.01,
    spawnHeight: 0,
    speed: [1.0, 1.5],
    sideSpeed: 0.05,
    buoyancy: 0.5,
    drift: 0.1,
    drag: 0.12,
    follow: 1,
    life: 0.7,
    size: 0.26,
  },
];

/** The paper's "before": one layer, one speed, no drift. */
export const ORIGINAL_LAYERS: readonly ParticleLayer[] = [
  {
    name: "core",
    capacity: 500,
    rate: 300,
    spawnRadius: 0.05,
    spawnHeight: 0,
    speed: [1.0, 1.0],
    sideSpeed: 0.05,
    buoyancy: 0,
    drift: 0,
    drag: 0,
    follow: 1,
    life: 0.7,
    size: 0.06,
  },
];
