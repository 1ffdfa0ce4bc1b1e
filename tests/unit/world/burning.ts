import {
  GROUPS,
  PAPER_LAYERS,
  type ParticleLayer,
} from "../../../src/world/particles/particle-layer.ts";
import { layerKey, PARTICLE_FLOATS, Particles } from "../../../src/world/particles/particles.ts";
import { HISTORY, Timeline } from "../../../src/world/timeline.ts";

export const [HAZE, CORE] = PAPER_LAYERS as [ParticleLayer, ParticleLayer];
/** Chances of the layers under test. */
export const KEY = layerKey(1, 0);

export interface Particle {
  readonly slot: number;
  readonly position: readonly [number, number, number];
  readonly velocity: readonly [number, number, number];
  readonly remaining: number;
  readonly age: number;
}

export function all({ state, layer }: Particles): Particle[] {
  return Array.from({ length: state.length / PARTICLE_FLOATS }, (_, slot) => {
    const [x, y, z, remaining, vx, vy, vz] = state.subarray(
      slot * PARTICLE_FLOATS,
    ) as unknown as number[];
    return {
      slot,
      position: [x!, y!, z!],
      velocity: [vx!, vy!, vz!],
      remaining: remaining!,
      age: layer.life - remaining!,
    };
  });
}
export const alive = (particles: Particles) =>
  all(particles).filter(({ remaining }) => remaining > 0);

/** What a stretch of ticks was like for the emitter. */
export interface Air {
  readonly way?: readonly [number, number, number];
  readonly wind?: readonly [number, number, number];
  readonly groups?: number;
}

/** Lets ticks pass, all alike. */
export function pass(timeline: Timeline, ticks: number, air: Air = {}): void {
  const { way = [0, 0, 0], wind = [0, 0, 0], groups = GROUPS } = air;
  for (let i = 0; i < ticks; i++) timeline.record(way, wind, groups);
}

/** A flame that has burnt for a while in still air. */
export function burning(layer: ParticleLayer, ticks = HISTORY, key = KEY) {
  const timeline = new Timeline(0);
  const particles = new Particles(layer, key);
  pass(timeline, ticks);
  particles.follow(timeline);
  return { timeline, particles };
}

/** Each particle alive before and after one more tick, in which none of them was born. */
export function oneTick(layer: ParticleLayer, air: Air = {}): [Particle, Particle][] {
  const { timeline, particles } = burning(layer);
  const before = alive(particles);
  pass(timeline, 1, air);
  particles.follow(timeline);
  const after = all(particles);
  return before
    .map(({ slot }, i): [Particle, Particle] => [before[i]!, after[slot]!])
    .filter(([earlier, later]) => later.age > earlier.age);
}
