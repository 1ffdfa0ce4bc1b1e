import { Gpu } from "../../src/gl/gpu.ts";
import { ParticleSystem } from "../../src/render/volumetric/particle-system.ts";
import { advance } from "../../src/world/advance.ts";
import { moveCamera, placeCandle } from "../../src/world/commands.ts";
import { PAPER_LAYERS, type ParticleLayer } from "../../src/world/particles/particle-layer.ts";
import { layerKey, PARTICLE_FLOATS, Particles } from "../../src/world/particles/particles.ts";
import { STILL } from "../../src/world/player/intent.ts";
import { TICK, Timeline } from "../../src/world/timeline.ts";
import { createWorld } from "./world.ts";

/** What happens to a layer of particles, tick by tick, and how it is watched. */
export interface Course {
  readonly layer: ParticleLayer;
  readonly ticks: number;
  /** Ticks from one `follow` to the next, in turn; long ones make passes of several ticks. */
  readonly pace: readonly number[];
  /** Whether the emitter swings through the room, as a hand does. */
  readonly isCarried?: boolean;
  /** Air's velocity past a resting emitter, in its unit per second. */
  readonly wind?: readonly [number, number, number];
  /** Groups that bear particles, for so many ticks each, in turn. Default: all. */
  readonly groups?: readonly { readonly ticks: number; readonly count: number }[];
}

/** How far two sets of particles are apart. */
export interface Difference {
  /** Largest difference of any number of any particle that lives in either set. */
  readonly worst: number;
  /** Particles alive when the sets were compared, most and fewest. */
  readonly most: number;
  readonly fewest: number;
}

/** Remaining life, in seconds, below which rounding decides whether a particle lives. */
const ABOUT_DEAD = 1e-4;

function withGpu<Result>(run: (gpu: Gpu) => Result): Result {
  const canvas = document.createElement("canvas");
  const gpu = new Gpu(canvas);
  try {
    const result = run(gpu);
    const error = canvas.getContext("webgl2")?.getError();
    if (error !== WebGL2RenderingContext.NO_ERROR) throw new Error(`WebGL error ${error}`);
    return result;
  } finally {
    gpu.dispose();
  }
}

function record(timeline: Timeline, { isCarried = false, wind = [0, 0, 0], groups }: Course): void {
  const { tick } = timeline;
  const way = isCarried
    ? [0.02 * Math.sin(tick * 0.11), 0.01 * Math.sin(tick * 0.07), 0.02 * Math.cos(tick * 0.13)]
    : [0, 0, 0];
  const air = wind.map((speed, axis) => speed - (way[axis] ?? 0) / TICK);
  const count = groupsAt(tick, groups);
  timeline.record(way, air, count, count > 0);
}

function groupsAt(tick: number, phases: Course["groups"] = [{ ticks: 1, count: 4 }]): number {
  const period = phases.reduce((sum, { ticks }) => sum + ticks, 0);
  let left = tick % period;
  for (const { ticks, count } of phases) {
    if (left < ticks) return count;
    left -= ticks;
  }
  return 0;
}

/** Difference of all particles, and how many of the second set live. */
function compare(one: Float32Array, other: Float32Array): { worst: number; living: number } {
  if (one.length !== other.length) throw new Error(`${one.length} floats, ${other.length} floats`);
  let worst = 0;
  let living = 0;
  for (let i = 0; i < one.length; i += PARTICLE_FLOATS) {
    const remaining = [one[i + 3] ?? Number.NaN, other[i + 3] ?? Number.NaN] as const;
    if (Math.max(...remaining) <= ABOUT_DEAD) continue;
    living++;
    for (let k = i; k < i + PARTICLE_FLOATS; k++) {
      const apart = Math.abs((one[k] ?? Number.NaN) - (other[k] ?? Number.NaN));
      worst = apart <= worst ? worst : apart; // NaN wins
    }
  }
  return { worst, living };
}

/**
 * Follows one course with the shader and with its CPU twin, comparing them at every stop.
 * Runs in the browser.
 */
export function compareTwins(course: Course): Difference {
  const { layer, ticks, pace } = course;
  const key = layerKey(7, 1);
  return withGpu((gpu) => {
    const shader = new ParticleSystem(gpu, layer, key);
    const twin = new Particles(layer, key);
    const timeline = new Timeline(0);
    const difference = { worst: 0, most: 0, fewest: Number.POSITIVE_INFINITY };
    for (let stop = 0; timeline.tick < ticks; stop++) {
      const next = timeline.tick + (pace[stop % pace.length] ?? 1);
      while (timeline.tick < next) record(timeline, course);
      shader.follow(timeline);
      twin.follow(timeline);
      const { worst, living } = compare(shader.read(), twin.state);
      difference.worst = Math.max(difference.worst, worst);
      difference.most = Math.max(difference.most, living);
      difference.fewest = Math.min(difference.fewest, living);
    }
    return difference;
  });
}

/** Follows a course twice on the GPU: all along, and anew at its end. Runs in the browser. */
export function compareLatecomer(course: Course): Difference {
  const { layer, ticks, pace } = course;
  const key = layerKey(7, 0);
  return withGpu((gpu) => {
    const witness = new ParticleSystem(gpu, layer, key);
    const timeline = new Timeline(0);
    for (let stop = 0; timeline.tick < ticks; stop++) {
      const next = timeline.tick + (pace[stop % pace.length] ?? 1);
      while (timeline.tick < next) record(timeline, course);
      witness.follow(timeline);
    }
    const latecomer = new ParticleSystem(gpu, layer, key);
    latecomer.follow(timeline);
    const { worst, living } = compare(latecomer.read(), witness.read());
    return { worst, most: living, fewest: living };
  });
}

/**
 * Both of the paper's layers on the GPU against their twins, through what a visitor does in 240
 * steps: he walks and turns with the candle, puts it down, and looks at it from afar.
 */
export function compareInRoom(framesPerSecond: number): Difference {
  const world = createWorld("paper", 3);
  return withGpu((gpu) => {
    const pairs = PAPER_LAYERS.map((layer, i) => ({
      shader: new ParticleSystem(gpu, layer, layerKey(world.seed, i)),
      twin: new Particles(layer, layerKey(world.seed, i)),
    }));
    const difference = { worst: 0, most: 0, fewest: Number.POSITIVE_INFINITY };
    for (let frame = 0; frame < 240; frame++) {
      const turn = Math.sin(frame / 20);
      advance(world, { ...STILL, forward: 1, runs: frame > 60, turn }, 1 / framesPerSecond);
      if (frame === 100) placeCandle(world);
      if (frame === 120) moveCamera(world, [4.5, 1.6, 4.5], 0.8, 0);
      if (frame === 180) moveCamera(world, [world.emitter[0], 1.6, world.emitter[2]], 0.8, 0);
      let all = 0;
      for (const { shader, twin } of pairs) {
        shader.follow(world.timeline);
        twin.follow(world.timeline);
        const { worst, living } = compare(shader.read(), twin.state);
        difference.worst = Math.max(difference.worst, worst);
        all += living;
      }
      difference.most = Math.max(difference.most, all);
      difference.fewest = Math.min(difference.fewest, all);
    }
    return difference;
  });
}
