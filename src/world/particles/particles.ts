import { Limiter } from "../flame/limiter.js";
import type { Vec3 } from "../geometry.js";
import { pcg, signedHigh, signedLow, unit } from "../random.js";
import { HISTORY, TICK, type Timeline } from "../timeline.js";
import { GROUPS, type ParticleLayer } from "./particle-layer.js";

/** Floats per particle: position, remaining life, velocity, life at birth. */
export const PARTICLE_FLOATS = 8;
/** Invisible remainder of light, as a share. A second after the flame went out there is less. */
const UNSEEN = 2e-3;

export function layerKey(seed: number, layer: number): number {
  return pcg((seed + pcg(layer)) >>> 0);
}

/** Emission of one layer in one tick. */
export interface Emission {
  /** Number of the first particle, counted from time 0. */
  first: number;
  count: number;
  /** Age of the first at the end of the tick, seconds; each later one is `1 / rate` younger. */
  age: number;
}

/** Emission in (tick, tick + 1], written to `out`. */
export function emissionOf(
  layer: ParticleLayer,
  tick: number,
  out: Emission = { first: 0, count: 0, age: 0 },
): Readonly<Emission> {
  // Counted from the start of the warm-up, so that no index is negative.
  const end = layer.rate * (tick + 1 + HISTORY) * TICK;
  out.first = Math.floor(layer.rate * (tick + HISTORY) * TICK) + 1;
  out.count = Math.floor(end) - out.first + 1;
  out.age = (end - out.first) / layer.rate;
  return out;
}

/**
 * The particle kernel on the CPU: twin of `shaders/particles/update.vert`, line by line.
 *
 * The shader is tested against it, and it simulates the few particles whose positions the CPU needs. Slots are
 * ordered by group; `slots` counts from the first.
 */
export class Particles {
  readonly layer: ParticleLayer;
  readonly state: Float32Array;
  readonly #key: number;
  #tick: number;
  readonly #limiter = new Limiter();
  readonly #births: Emission = { first: 0, count: 0, age: 0 };

  constructor(layer: ParticleLayer, key: number, slots = layer.capacity) {
    this.layer = layer;
    this.#key = key;
    this.#tick = Number.NEGATIVE_INFINITY;
    this.state = new Float32Array(slots * PARTICLE_FLOATS);
  }

  /** Catches up with the timeline. */
  follow(timeline: Timeline): void {
    this.#tick = Math.max(this.#tick, timeline.tick - HISTORY);
    for (; this.#tick < timeline.tick; this.#tick++) {
      this.#step(timeline, this.#tick);
      this.#limiter.target = this.#abundance();
      this.#limiter.advance(TICK);
    }
  }

  /** Centre of the particles alive, weighted by their alpha: from the emitter, in its unit. */
  centre(out: Vec3): Vec3 {
    const { state, layer } = this;
    let weight = 0;
    out[0] = out[1] = out[2] = 0;
    for (let i = 0; i < state.length; i += PARTICLE_FLOATS) {
      const alpha = Math.max(0, (state[i + 3] ?? 0) / layer.life);
      weight += alpha;
      for (const axis of [0, 1, 2] as const) out[axis] += alpha * (state[i + axis] ?? 0);
    }
    for (const axis of [0, 1, 2] as const) out[axis] /= Math.max(weight, 1e-6);
    return out;
  }

  /** Light of the particles alive, as a share of what it is of a flame that burns on; without flashes. */
  get light(): number {
    return this.#limiter.light > UNSEEN ? this.#limiter.light : 0;
  }

  /** Sum of the alphas of the particles alive, as a share of what it is of a flame that burns on. */
  #abundance(): number {
    const { state, layer } = this;
    let seconds = 0;
    for (let i = 3; i < state.length; i += PARTICLE_FLOATS) seconds += Math.max(0, state[i] ?? 0);
    const births = (layer.rate * state.length) / (PARTICLE_FLOATS * layer.capacity);
    return seconds / (0.5 * births * layer.life * layer.life);
  }

  #step(timeline: Timeline, tick: number): void {
    const { layer, state } = this;
    const { first, count, age: eldest } = emissionOf(layer, tick, this.#births);
    const groupSize = layer.capacity / GROUPS;
    const firstSlot = first % layer.capacity;
    const groups = timeline.groups(tick, layer.source);
    const tickKey = pcg((tick + this.#key) >>> 0);
    const dragged = 1 - Math.exp(-layer.drag * TICK);
    const stays = 1 - layer.follow;
    for (let slot = 0, i = 0; i < state.length; slot++, i += PARTICLE_FLOATS) {
      const group = Math.floor(slot / groupSize);
      const turn = (slot - group * groupSize) * GROUPS + group;
      const birth = (turn + layer.capacity - firstSlot) % layer.capacity;
      if (birth < count && group < groups) {
        this.#emit(i, birth);
        // The emitter has moved on since.
        const elapsedTicks = (eldest - birth / layer.rate) / TICK;
        for (let axis = 0; axis < 3; axis++) {
          state[i + axis]! -= timeline.way(tick, axis) * stays * elapsedTicks;
        }
        continue;
      }
      if (state[i + 3]! <= 0) continue;
      const hash = pcg((slot + tickKey) >>> 0);
      state[i + 4]! += layer.drift * TICK * signedHigh(hash);
      state[i + 5]! += layer.buoyancy * TICK;
      state[i + 6]! += layer.drift * TICK * signedLow(hash);
      for (let axis = 0; axis < 3; axis++) {
        const shift = timeline.way(tick, axis) * stays;
        // The timeline's wind is relative to the emitter; a particle that stays behind has the room's.
        const wind = timeline.wind(tick, axis) + shift / TICK;
        if (axis !== 1) state[i + 4 + axis]! += (wind - state[i + 4 + axis]!) * dragged;
        state[i + axis]! += state[i + 4 + axis]! * TICK - shift;
      }
      state[i + 3]! -= TICK;
    }
  }

  /** Emits the tick's particle of a number, from 0, in the slot whose floats begin at `i`. */
  #emit(i: number, number: number): void {
    const { layer, state } = this;
    const age = this.#births.age - number / layer.rate;
    const birth = (this.#births.first + number) >>> 0;
    const h0 = pcg((birth + this.#key) >>> 0);
    const h1 = pcg(h0);
    const h2 = pcg(h1);
    const slow = layer.speed[0];
    const fast = layer.speed[1];
    state[i + 4] = layer.sideSpeed * signedHigh(h1);
    state[i + 5] = slow + (fast - slow) * unit(h2);
    state[i + 6] = layer.sideSpeed * signedLow(h1);
    state[i + 7] = layer.life;
    state[i] = layer.spawnRadius * signedHigh(h0) + state[i + 4]! * age;
    const height = layer.spawnHeight + layer.spawnDepth * signedLow(h2);
    state[i + 1] = height + state[i + 5]! * age;
    state[i + 2] = layer.spawnRadius * signedLow(h0) + state[i + 6]! * age;
    state[i + 3] = layer.life - age;
  }
}

/** Creates what `World.sample` is, from the layers of a look. */
export type CreateSample = (layers: readonly ParticleLayer[], seed: number) => Particles;

export const createSample: CreateSample = (layers, seed) => {
  const brightest = layers.length - 1;
  const layer = layers[brightest];
  if (!layer) throw new Error("A look of the paper has particle layers.");
  return new Particles(layer, layerKey(seed, brightest), layer.capacity / GROUPS);
};
