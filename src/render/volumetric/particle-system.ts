import updateFrag from "../../../shaders/particles/update.frag";
import updateVert from "../../../shaders/particles/update.vert";
import type { Buffer, Draw, Gpu, Program, UniformBlock, VertexArray } from "../../gl/gpu.js";
import { GROUPS, type ParticleLayer } from "../../world/particles/particle-layer.js";
import { emissionOf, PARTICLE_FLOATS } from "../../world/particles/particles.js";
import { pcg } from "../../world/random.js";
import { HISTORY, TICK, type Timeline } from "../../world/timeline.js";

/** Ticks that one pass can take; the shader's MAX_TICKS. */
const MAX_TICKS = 2;
const STRIDE = PARTICLE_FLOATS * Float32Array.BYTES_PER_ELEMENT;

interface Half {
  readonly buffer: Buffer;
  readonly vertexArray: VertexArray;
}

/** Varyings that a program with the kernel captures. */
export const FEEDBACK: readonly string[] = ["vPositionLife", "vVelocitySpan"];

/**
 * One layer of particles on the GPU, moved by transform feedback.
 *
 * Its state is a function of the timeline alone, so it can be recreated at any time.
 */
export class ParticleSystem {
  readonly layer: ParticleLayer;
  readonly #gpu: Gpu;
  /** Advances particles without drawing; shared by all layers of a context. */
  readonly #program: Program;
  readonly #block: UniformBlock;
  readonly #key: number;
  /** The last pass went from one half to the other. */
  #from: Half;
  #to: Half;
  #tick = Number.NEGATIVE_INFINITY;
  #groups = 0;
  /** Tick until which each group is advanced: until no particle of it lives in either half. */
  readonly #activeUntil = new Float64Array(GROUPS);
  /** Uniforms of the last pass; one object serves all. */
  readonly #uniforms = {
    uGroupSize: 0,
    uTicks: 0,
    uGroups: 0,
    uFirstTurn: 0,
    uFirstKey: 0,
    uTickKeys: new Uint32Array(MAX_TICKS),
    uBirths: new Uint32Array(MAX_TICKS),
    uOldestAge: new Float32Array(MAX_TICKS),
    uDisplacement: new Float32Array(MAX_TICKS * 3),
    uWindVelocity: new Float32Array(MAX_TICKS * 2),
  };

  /** @param key seed of this layer, see `layerKey` */
  constructor(gpu: Gpu, layer: ParticleLayer, key: number) {
    this.#gpu = gpu;
    this.#program = gpu.program("particles/update", updateVert, updateFrag, { feedback: FEEDBACK });
    this.#key = key;
    this.layer = layer;
    this.#from = this.#half("a");
    this.#to = this.#half("b");
    this.#uniforms.uGroupSize = layer.capacity / GROUPS;
    this.#block = gpu.uniformBlock(this.#program, "Layer");
    this.#block.update({
      tick: TICK,
      interval: 1 / layer.rate,
      life: layer.life,
      spawnRadius: layer.spawnRadius,
      spawnHeight: layer.spawnHeight,
      spawnDepth: layer.spawnDepth,
      sideSpeed: layer.sideSpeed,
      minSpeed: layer.speed[0],
      maxSpeed: layer.speed[1],
      buoyancy: layer.buoyancy * TICK,
      drift: layer.drift * TICK,
      damping: Math.exp(-layer.drag * TICK),
    });
  }

  #half(name: string): Half {
    const label = `particles/${this.layer.name}/${name}`;
    const buffer = this.#gpu.buffer(label, this.layer.capacity * STRIDE, "dynamic");
    const vertexArray = this.#gpu.vertexArray(label, {
      attributes: {
        0: { buffer, size: 4, stride: STRIDE },
        1: { buffer, size: 4, stride: STRIDE, offset: 16 },
      },
      count: this.layer.capacity,
    });
    return { buffer, vertexArray };
  }

  /** Slots that may hold a live particle, from the first one on. */
  get count(): number {
    return this.#groups * (this.layer.capacity / GROUPS);
  }

  /** Catches up with the timeline without drawing. */
  follow(timeline: Timeline): void {
    while (this.#beginPass(timeline)) this.#advance();
  }

  /**
   * Catches up with the timeline and draws; the last pass does both at once.
   *
   * @param draw its program captures `FEEDBACK`, and its vertex shader includes the kernel
   */
  draw(timeline: Timeline, draw: Omit<Draw, "vertexArray" | "primitive" | "count" | "into">): void {
    let hasPass = this.#beginPass(timeline);
    while (hasPass && this.#tick < timeline.tick) {
      this.#advance();
      hasPass = this.#beginPass(timeline);
    }
    this.#gpu.draw({
      ...draw,
      vertexArray: this.#from.vertexArray,
      primitive: "points",
      count: this.count,
      // Without a new tick the last pass is drawn again, and its result dropped.
      into: hasPass ? this.#to.buffer : undefined,
      uniforms: { ...draw.uniforms, ...this.#uniforms },
      blocks: { ...draw.blocks, Layer: this.#block },
    });
  }

  #advance(): void {
    this.#gpu.draw({
      program: this.#program,
      target: null,
      primitive: "points",
      vertexArray: this.#from.vertexArray,
      into: this.#to.buffer,
      count: this.count,
      uniforms: this.#uniforms,
      blocks: { Layer: this.#block },
    });
  }

  /** Prepares the next pass; false if no tick is left. */
  #beginPass(timeline: Timeline): boolean {
    const { layer } = this;
    // Particles born before that are dead.
    const lifetime = Math.ceil(layer.life / TICK) + 1;
    const oldest = timeline.tick - Math.min(HISTORY, lifetime);
    if (this.#tick < oldest) {
      this.#tick = oldest;
      // Both halves may hold particles that the ticks between would have aged.
      this.#activate(this.#groups, oldest);
    }
    if (this.#tick >= timeline.tick) return false;
    [this.#from, this.#to] = [this.#to, this.#from];
    const { first } = emissionOf(layer, this.#tick);
    const groups = timeline.groups(this.#tick, layer.source);
    const end = Math.min(timeline.tick, this.#tick + MAX_TICKS);
    let ticks = 0;
    while (this.#tick < end && timeline.groups(this.#tick, layer.source) === groups) {
      this.#setTick(timeline, this.#tick, ticks);
      this.#tick++;
      ticks++;
    }
    this.#activate(groups, this.#tick);
    this.#uniforms.uTicks = ticks;
    this.#uniforms.uGroups = groups;
    this.#uniforms.uFirstTurn = first % layer.capacity;
    this.#uniforms.uFirstKey = (first + this.#key) >>> 0;
    return true;
  }

  #setTick(timeline: Timeline, tick: number, i: number): void {
    const { layer } = this;
    const { uTickKeys, uBirths, uOldestAge, uDisplacement, uWindVelocity } = this.#uniforms;
    const { count, age } = emissionOf(layer, tick);
    uTickKeys[i] = pcg((tick + this.#key) >>> 0);
    uBirths[i] = count;
    uOldestAge[i] = age;
    const staysBehind = 1 - layer.follow;
    for (let axis = 0; axis < 3; axis++) {
      uDisplacement[i * 3 + axis] = timeline.way(tick, axis) * staysBehind;
    }
    const drag = 1 - Math.exp(-layer.drag * TICK);
    const airspeed = (axis: 0 | 2) =>
      timeline.wind(tick, axis) + uDisplacement[i * 3 + axis]! / TICK;
    uWindVelocity[i * 2] = airspeed(0) * drag;
    uWindVelocity[i * 2 + 1] = airspeed(2) * drag;
  }

  #activate(groups: number, tick: number): void {
    // Life of the last birth, and two more passes of MAX_TICKS.
    const until = tick + this.layer.life / TICK + 2 * MAX_TICKS;
    for (let group = 0; group < groups; group++) this.#activeUntil[group] = until;
    this.#groups = this.#activeUntil.findLastIndex((until) => until >= tick) + 1;
  }

  /** The particles, `PARTICLE_FLOATS` each. For tests: it waits for the GPU. */
  read(): Float32Array {
    return this.#to.buffer.read(new Float32Array(this.layer.capacity * PARTICLE_FLOATS));
  }

  dispose(): void {
    for (const { buffer, vertexArray } of [this.#from, this.#to]) {
      vertexArray.dispose();
      buffer.dispose();
    }
    this.#block.dispose();
  }
}
