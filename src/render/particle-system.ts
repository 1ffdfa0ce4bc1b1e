import updateFrag from "../../shaders/particles/update.frag";
import updateVert from "../../shaders/particles/update.vert";
import type { Buffer } from "../gl/buffer.js";
import type { Gpu } from "../gl/gpu.js";
import type { Program } from "../gl/program.js";
import type { UniformBlock } from "../gl/uniform-block.js";
import type { VertexArray } from "../gl/vertex-array.js";
import { GROUPS, type ParticleLayer } from "../world/particle-layer.js";
import { birthsOf, FLOATS } from "../world/particles.js";
import { pcg } from "../world/random.js";
import { MEMORY, TICK, type Timeline } from "../world/timeline.js";

/** Ticks that one pass can take; the shader's MAX_TICKS. */
const MAX_TICKS = 8;
const STRIDE = FLOATS * Float32Array.BYTES_PER_ELEMENT;

/** Half of the double buffer: particles, and how a vertex shader reads them. */
interface Half {
  readonly buffer: Buffer;
  readonly vertexArray: VertexArray;
}

/** The program that moves particles; one serves all layers of a context. */
export function particleProgram(gpu: Gpu): Program {
  return gpu.program("particles/update", updateVert, updateFrag, {
    feedback: ["vPositionLife", "vVelocitySpan"],
  });
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
  #now: Half;
  #next: Half;
  #tick = Number.NEGATIVE_INFINITY;
  #groups = GROUPS;
  /** Tick up to which group `n` is moved: until both halves of the buffer hold none of it alive. */
  readonly #movedUntil = new Float64Array(GROUPS);
  readonly #tickKeys = new Uint32Array(MAX_TICKS);
  readonly #births = new Uint32Array(MAX_TICKS * 4);
  readonly #way = new Float32Array(MAX_TICKS * 4);
  readonly #wind = new Float32Array(MAX_TICKS * 4);

  /** @param key what makes this layer's chances its own, see `layerKey` */
  constructor(gpu: Gpu, program: Program, layer: ParticleLayer, key: number) {
    this.#gpu = gpu;
    this.#program = program;
    this.#key = key;
    this.layer = layer;
    this.#now = this.#half("a");
    this.#next = this.#half("b");
    this.#block = gpu.uniformBlock(program, "Layer");
    this.#block.update({
      tick: TICK,
      rate: layer.rate,
      spawnRadius: layer.spawnRadius,
      spawnHeight: layer.spawnHeight,
      slowest: layer.speed[0],
      fastest: layer.speed[1],
      sideSpeed: layer.sideSpeed,
      buoyancy: layer.buoyancy,
      drift: layer.drift,
      dragged: 1 - Math.exp(-layer.drag * TICK),
      stays: 1 - layer.follow,
      life: layer.life,
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

  /** Particles as of the timeline's last tick. */
  get vertexArray(): VertexArray {
    return this.#now.vertexArray;
  }

  /** Slots that hold a particle or did so lately: from the first one on, what is worth drawing. */
  get count(): number {
    return this.#groups * (this.layer.capacity / GROUPS);
  }

  /** Catches up with the timeline. */
  follow(timeline: Timeline): void {
    // Whatever was born before that is dead by now.
    const lifetime = Math.ceil(this.layer.life / TICK) + 1;
    this.#tick = Math.max(this.#tick, timeline.tick - Math.min(MEMORY, lifetime));
    while (this.#tick < timeline.tick) {
      const ticks = Math.min(MAX_TICKS, timeline.tick - this.#tick);
      for (let i = 0; i < ticks; i++) this.#describe(timeline, this.#tick + i, i);
      this.#gpu.transform({
        program: this.#program,
        vertexArray: this.#now.vertexArray,
        into: this.#next.buffer,
        count: this.count,
        blocks: { Layer: this.#block },
        uniforms: {
          uTicks: ticks,
          uCapacity: this.layer.capacity,
          uKey: this.#key,
          uTickKeys: this.#tickKeys,
          uBirths: this.#births,
          uWay: this.#way,
          uWind: this.#wind,
        },
      });
      [this.#now, this.#next] = [this.#next, this.#now];
      this.#tick += ticks;
    }
  }

  #describe(timeline: Timeline, tick: number, i: number): void {
    const { layer } = this;
    const births = birthsOf(layer, tick);
    const groups = timeline.groups(tick);
    this.#tickKeys[i] = pcg((tick + this.#key) >>> 0);
    this.#births[i * 4] = births.first % layer.capacity;
    this.#births[i * 4 + 1] = births.first;
    this.#births[i * 4 + 2] = births.count;
    this.#births[i * 4 + 3] = groups;
    for (let axis = 0; axis < 3; axis++) {
      this.#way[i * 4 + axis] = timeline.way(tick, axis);
      this.#wind[i * 4 + axis] = timeline.wind(tick, axis);
    }
    this.#way[i * 4 + 3] = births.age;
    // The last dies within its life; then two more passes, each of MAX_TICKS at most.
    const until = tick + layer.life / TICK + 2 * MAX_TICKS;
    for (let group = 0; group < groups; group++) this.#movedUntil[group] = until;
    this.#groups = this.#movedUntil.findLastIndex((until) => until >= tick) + 1;
  }

  /** Copies the particles back, `FLOATS` each: for tests, since it waits for the GPU. */
  read(): Float32Array {
    return this.#now.buffer.read(new Float32Array(this.layer.capacity * FLOATS));
  }

  dispose(): void {
    for (const { buffer, vertexArray } of [this.#now, this.#next]) {
      vertexArray.dispose();
      buffer.dispose();
    }
    this.#block.dispose();
  }
}
