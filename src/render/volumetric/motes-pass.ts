import dustVert from "../../../shaders/volumetric/dust.vert";
import moteFrag from "../../../shaders/volumetric/mote.frag";
import sparkVert from "../../../shaders/volumetric/spark.vert";
import type { Gpu, Program, UniformBlock, UniformValue } from "../../gl/gpu.js";
import type { Rgb } from "../../light/color.js";
import { sootRadiance } from "../../light/soot.js";
import type { ParticleLayer } from "../../world/particles/particle-layer.js";
import { layerKey } from "../../world/particles/particles.js";
import type { World } from "../../world/world.js";
import type { IrradianceVolume } from "../gi/irradiance-volume.js";
import { FEEDBACK, ParticleSystem } from "./particle-system.js";
import type { CompositedFrame } from "./volumetric-target.js";

/** Kelvin of a droplet of burning wax, from birth to death. */
const COOLING = [1850, 1700, 1500, 1300, 1100, 1000];
const GLOW = Float32Array.from(COOLING.flatMap((temperature) => [...sootRadiance(temperature)]));

/** Dust and sparks, as point sprites. */
export class MotesPass {
  readonly #gpu: Gpu;
  readonly #dust: Program;
  readonly #spark: Program;
  #systems: ParticleSystem[] = [];

  constructor(gpu: Gpu) {
    this.#gpu = gpu;
    this.#dust = gpu.program("volumetric/dust", dustVert, moteFrag, { feedback: FEEDBACK });
    this.#spark = gpu.program("volumetric/spark", sparkVert, moteFrag, {
      defines: { GLOWS: COOLING.length },
      feedback: FEEDBACK,
    });
  }

  get particles(): number {
    return this.#systems.reduce((sum, { count }) => sum + count, 0);
  }

  setLayers({ seed }: World, layers: readonly ParticleLayer[]): void {
    for (const system of this.#systems) system.dispose();
    this.#systems = layers.map(
      (layer, i) => new ParticleSystem(this.#gpu, layer, layerKey(seed, i)),
    );
  }

  /** Blends one layer over the target. A layer that is not drawn catches up when it is. */
  render(
    name: "dust" | "spark",
    { target, depth }: Pick<CompositedFrame, "target" | "depth">,
    world: World,
    frame: UniformBlock,
    light: UniformBlock,
    volume: IrradianceVolume,
    moonlight: Rgb,
  ): void {
    const system = this.#systems.find(({ layer }) => layer.name === name);
    if (!system) return;
    const [x, y, z] = world.emitter; // not interpolated: particles that stay behind do not follow the hand
    const { flameScale } = world.setup;
    const uniforms: Record<string, UniformValue> = {
      uEmitter: [x, y, z, flameScale],
      uSize: system.layer.size * flameScale,
      uExtrapolation: world.remainder,
    };
    const isDust = name === "dust";
    if (isDust) uniforms.uMoonlight = moonlight;
    else uniforms.uGlow = GLOW;
    system.draw(world.timeline, {
      program: isDust ? this.#dust : this.#spark,
      target,
      textures: { uDepth: depth, ...(isDust ? volume.textures : {}) },
      uniforms,
      blocks: { Frame: frame, ...(isDust ? { Light: light, Volume: volume.block } : {}) },
      blend: "premultiplied",
      cull: "none",
    });
  }
}
