import updateFrag from "../../../shaders/particles/update.frag";
import updateVert from "../../../shaders/particles/update.vert";
import type { Buffer } from "../../gl/buffer.js";
import type { Draw, Gpu } from "../../gl/gpu.js";
import type { Program, UniformValue } from "../../gl/program.js";
import type { UniformBlock } from "../../gl/uniform-block.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import { GROUPS, type ParticleLayer } from "../../world/particles/particle-layer.js";
import { emissionOf, PARTICLE_FLOATS } from "../../world/particles/particles.js";
import { pcg } from "../../world/random.js";
import { HISTORY, TICK, type Timeline } from "../../world/timeline.js";

/** Ticks that one pass can take; the shader's MAX_TICKS. */
const MAX_TICKS = 2;
const STRIDE = PARTICLE_FLOATS * Float32Array.BYTES_PER_ELEMENT;

/** Half of the double buffer: particles, and how a vertex shader reads them. */
interface Half {
  readonly buffer: Buffer;
  readonly vertexArray: VertexArray;
}

/** What a program must capture whose vertex shader includes the kernel. */
export const FEEDBACK: readonly string[] = ["vPositionLife", "vVelocitySpan"];

/** The program that moves particles unseen; one serves all layers of a context. */
export function particleProgram(gpu: Gpu): Program {
  return gpu.program("particles/update", updateVert, updateFrag, { feedback: FEEDBACK });
}

/**
 * One layer of particles on the GPU, moved by transform feedback.
 *
 * It follows a timeline: what it holds depends on the timeline's memory alone, so it can be thrown
 * away and made anew in the middle of a flame.
 */
export class ParticleSystem {
  readonly layer: ParticleLayer;
  readonly #gpu: Gpu;
  readonly #program: Program;
  readonly #block: UniformBlock;
  readonly #key: number;
  /** The last pass went from one half to the other. */
  #from: Half;
  #to: Half;
  #tick = Number.NEGATIVE_INFINITY;
  #groups = GROUPS;
  /** Tick up to which group `n` is moved: until both halves of the buffer hold none of it alive. */
  readonly #movedUntil = new Float64Array(GROUPS);
  readonly #tickKeys = new Uint32Array(MAX_TICKS);
  readonly #births = new Uint32Array(MAX_TICKS);
  readonly #eldest = new Float32Array(MAX_TICKS);
  readonly #left = new Float32Array(MAX_TICKS * 3);
  readonly #blown = new Float32Array(MAX_TICKS * 2);
  /** Uniforms of the last pass, kept from pass to pass. */
  readonly #pass: Record<string, UniformValue>;

  /** @param key what makes this layer's chances its own, see `layerKey` */
  constructor(gpu: Gpu, program: Program, layer: ParticleLayer, key: number) {
    this.#gpu = gpu;
    this.#program = program;
    this.#key = key;
    this.layer = layer;
    this.#from = this.#half("a");
    this.#to = this.#half("b");
    this.#pass = {
      uGroupSize: layer.capacity / GROUPS,
      uTickKeys: this.#tickKeys,
      uBirths: this.#births,
      uEldest: this.#eldest,
      uLeft: this.#left,
      uBlown: this.#blown,
    };
    this.#block = gpu.uniformBlock(program, "Layer");
    this.#block.update({
      tick: TICK,
      interval: 1 / layer.rate,
      life: layer.life,
      spawnRadius: layer.spawnRadius,
      spawnHeight: layer.spawnHeight,
      spawnDepth: layer.spawnDepth,
      sideSpeed: layer.sideSpeed,
      slowest: layer.speed[0],
      fastest: layer.speed[1],
      lift: layer.buoyancy * TICK,
      push: layer.drift * TICK,
      kept: Math.exp(-layer.drag * TICK),
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

  /** Slots that hold a particle or did so lately: from the first one on, what is worth drawing. */
  get count(): number {
    return this.#groups * (this.layer.capacity / GROUPS);
  }

  /** Catches up with the timeline, unseen. */
  follow(timeline: Timeline): void {
    while (this.#beginPass(timeline)) this.#move();
  }

  /**
   * Catches up with the timeline and draws; the last pass does both at once.
   *
   * @param draw its program captures `FEEDBACK`, and its vertex shader includes the kernel
   */
  draw(timeline: Timeline, draw: Omit<Draw, "vertexArray" | "primitive" | "count" | "into">): void {
    let moves = this.#beginPass(timeline);
    while (moves && this.#tick < timeline.tick) {
      this.#move();
      moves = this.#beginPass(timeline);
    }
    this.#gpu.draw({
      ...draw,
      vertexArray: this.#from.vertexArray,
      primitive: "points",
      count: this.count,
      // Between two ticks the last pass is drawn once more, and nothing kept.
      into: moves ? this.#to.buffer : undefined,
      uniforms: { ...draw.uniforms, ...this.#pass },
      blocks: { ...draw.blocks, Layer: this.#block },
    });
  }

  #move(): void {
    this.#gpu.transform({
      program: this.#program,
      vertexArray: this.#from.vertexArray,
      into: this.#to.buffer,
      count: this.count,
      uniforms: this.#pass,
      blocks: { Layer: this.#block },
    });
  }

  /** Turns to the next ticks, if there are any: as many as one pass can take. */
  #beginPass(timeline: Timeline): boolean {
    const { layer } = this;
    // Whatever was born before that is dead by now.
    const lifetime = Math.ceil(layer.life / TICK) + 1;
    this.#tick = Math.max(this.#tick, timeline.tick - Math.min(HISTORY, lifetime));
    if (this.#tick >= timeline.tick) return false;
    [this.#from, this.#to] = [this.#to, this.#from];
    const { first } = emissionOf(layer, this.#tick);
    const groups = timeline.groups(this.#tick, layer.source);
    const end = Math.min(timeline.tick, this.#tick + MAX_TICKS);
    let ticks = 0;
    while (this.#tick < end && timeline.groups(this.#tick, layer.source) === groups) {
      this.#describe(timeline, this.#tick, ticks);
      this.#tick++;
      ticks++;
    }
    this.#keep(groups, this.#tick);
    this.#pass.uTicks = ticks;
    this.#pass.uGroups = groups;
    this.#pass.uFirstTurn = first % layer.capacity;
    this.#pass.uFirstKey = (first + this.#key) >>> 0;
    return true;
  }

  #describe(timeline: Timeline, tick: number, i: number): void {
    const { layer } = this;
    const { count, age } = emissionOf(layer, tick);
    this.#tickKeys[i] = pcg((tick + this.#key) >>> 0);
    this.#births[i] = count;
    this.#eldest[i] = age;
    const stays = 1 - layer.follow;
    for (let axis = 0; axis < 3; axis++) {
      this.#left[i * 3 + axis] = timeline.way(tick, axis) * stays;
    }
    const dragged = 1 - Math.exp(-layer.drag * TICK);
    const airspeed = (axis: 0 | 2) => timeline.wind(tick, axis) + this.#left[i * 3 + axis]! / TICK;
    this.#blown[i * 2] = airspeed(0) * dragged;
    this.#blown[i * 2 + 1] = airspeed(2) * dragged;
  }

  #keep(groups: number, tick: number): void {
    // The last dies within its life; then two more passes, each of MAX_TICKS at most.
    const until = tick + this.layer.life / TICK + 2 * MAX_TICKS;
    for (let group = 0; group < groups; group++) this.#movedUntil[group] = until;
    this.#groups = this.#movedUntil.findLastIndex((until) => until >= tick) + 1;
  }

  /** Copies the particles back, `FLOATS` each: for tests, since it waits for the GPU. */
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
