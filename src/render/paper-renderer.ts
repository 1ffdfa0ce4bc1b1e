import { mat4 } from "gl-matrix";
import candleFrag from "../../shaders/paper/candle.frag";
import meshVert from "../../shaders/paper/mesh.vert";
import particleFrag from "../../shaders/paper/particle.frag";
import particleVert from "../../shaders/paper/particle.vert";
import roomFrag from "../../shaders/paper/room.frag";
import fxaaFrag from "../../shaders/post/fxaa.frag";
import upscaleFrag from "../../shaders/post/upscale.frag";
import type {
  Box,
  Gpu,
  Program,
  RenderTarget,
  Surface as Target,
  UniformBlock,
} from "../gl/gpu.js";
import { candleLight } from "../light/candle-light.js";
import type { Features, Look } from "../settings.js";
import type { ParticleLayer } from "../world/particles/particle-layer.js";
import { layerKey } from "../world/particles/particles.js";
import type { World } from "../world/world.js";
import { frameBlock } from "./frame-block.js";
import type { FrameSettings } from "./frame-settings.js";
import { type Mesh, surfaceSampling, uploadModel } from "./mesh/mesh.js";
import type { Tier } from "./quality.js";
import type { Models, Renderer } from "./renderer.js";
import { FEEDBACK, ParticleSystem } from "./volumetric/particle-system.js";

/** The paper's light has no unit; this exposes its white wall at arm's length just below white. */
const EXPOSURE = 0.62;
/** Light of one particle where it is brightest, in display units; without a gradient, its opacity. */
const GLOW = { core: 0.2, haze: 0.012 } as const;
const FLAT_GLOW = { core: 0.8, haze: 0.08 } as const;

/** Least difference of the surfaces' codes in alpha at an edge that is antialiased at `low`. */
const CODE_DIFFERENCE = 0.02;
/** At `low`, one level of the maps that change shading less than albedo does. */
const LEVELS = { uAlbedo: "level", uNormal: "level", uOcclusionRoughness: "texel" } as const;

/** Define that chooses the normals. */
type Normals = Readonly<Record<string, number>>;

const SHADERS = {
  room: [meshVert, roomFrag],
  candle: [meshVert, candleFrag],
  particle: [particleVert, particleFrag],
} as const;

/**
 * The paper's forward renderer: room, candle, particles, straight to display colour.
 *
 * "Dynamic Fire Effects Using OpenGL Rasterization Techniques": `paper` is its final product,
 * `original` its "before".
 */
export class PaperRenderer implements Renderer {
  readonly #gpu: Gpu;
  readonly #tier: Tier;
  readonly #frame: UniformBlock;
  readonly #light: UniformBlock;
  readonly #models: Readonly<Record<"room" | "candle", readonly Mesh[]>>;
  #systems: ParticleSystem[] = [];
  #target: RenderTarget | null = null;
  /** Samples can only be resolved to a target of their own format: the canvas has no alpha. */
  #resolved: RenderTarget | null = null;
  /** Where edges are antialiased after shading: samples are what a CPU pays most for. */
  readonly #isFiltered: boolean;
  /** Copies the frame to the canvas, or antialiases it. */
  readonly #present: Program;
  #size = { width: 1, height: 1 };
  #exposure = EXPOSURE;

  constructor(gpu: Gpu, { room, candle }: Models, tier: Tier, look: Look) {
    this.#gpu = gpu;
    this.#tier = tier;
    const normals = { [look === "original" ? "FACETS" : "NORMAL_MAPS"]: 1 };
    this.#isFiltered = tier.name === "low";
    const defines = { EDGE_LEAST: CODE_DIFFERENCE };
    this.#present = this.#isFiltered
      ? gpu.pass("post/fxaa", fxaaFrag, { defines })
      : gpu.pass("post/upscale", upscaleFrag);
    const program = this.#program("room", { ...normals, CUTOUT: 0 });
    this.#frame = gpu.uniformBlock(program, "Frame");
    this.#light = gpu.uniformBlock(program, "Light");
    this.#models = { room: uploadModel(gpu, room), candle: uploadModel(gpu, candle) };
    for (const name of ["room", "candle"] as const) {
      for (const mesh of this.#models[name]) this.#surfaceProgram(name, normals, mesh);
    }
  }

  resize(width: number, height: number): void {
    this.#size = { width, height };
    this.#target?.dispose();
    this.#resolved?.dispose();
    const options = { label: "frame", width, height, color: ["RGBA8"] } as const;
    const samples = this.#isFiltered ? 1 : this.#tier.samples;
    this.#target = this.#gpu.renderTarget({ ...options, depth: "buffer", samples });
    this.#resolved = this.#isFiltered ? null : this.#gpu.renderTarget(options);
  }

  setLayers({ seed }: World, layers: readonly ParticleLayer[]): void {
    for (const system of this.#systems) system.dispose();
    this.#systems = layers.map(
      (layer, i) => new ParticleSystem(this.#gpu, layer, layerKey(seed, i)),
    );
  }

  get particles(): number {
    return this.#systems.reduce((sum, { count }) => sum + count, 0);
  }

  render(world: World, view: FrameSettings): void {
    const gpu = this.#gpu;
    const target = this.#target!;
    const { features } = view;
    const frame = this.#updateBlocks(world, view);
    gpu.setColorSpace("srgb");
    gpu.clear(target, [0, 0, 0, 1]);
    const smooth = features.normalMaps ? "NORMAL_MAPS" : "VERTICES";
    const normals = { [world.look === "original" ? "FACETS" : smooth]: 1 };
    this.#drawSurfaces(target, "room", normals, [0, 0, 0, 1]);
    if (features.candle) {
      const [x, y, z] = world.interpolated.foot;
      const placement = [x, y, z, world.setup.candleScale];
      this.#drawSurfaces(target, "candle", normals, placement);
    }
    if (features.particles) this.#drawParticles(target, world, features, frame);
    if (this.#resolved) gpu.resolve(target, this.#resolved);
    const { color } = this.#resolved ?? target;
    gpu.draw({
      program: this.#present,
      target: "canvas",
      textures: { uSource: color, uSmooth: color },
      sampling: { uSource: "nearest" },
    });
  }

  #updateBlocks(world: World, settings: FrameSettings): ReturnType<typeof frameBlock> {
    this.#exposure = EXPOSURE * 2 ** settings.exposure;
    const frame = frameBlock(world, settings, this.#size, this.#exposure);
    this.#frame.update(frame);
    const light = candleLight(world, settings.features, settings.isStill);
    this.#light.update({ ...light, attenuates: light.attenuates ? 1 : 0 });
    return frame;
  }

  /** Programs of their own, since a software renderer executes both sides of an `if`. Compiled on first use. */
  #program(name: keyof typeof SHADERS, defines: Readonly<Record<string, number>>): Program {
    const feedback = name === "particle" ? FEEDBACK : [];
    return this.#gpu.program(`paper/${name}`, ...SHADERS[name], { defines, feedback });
  }

  #surfaceProgram(name: "room" | "candle", normals: Normals, { isCutOut }: Mesh): Program {
    return this.#program(name, { ...normals, CUTOUT: Number(isCutOut) });
  }

  #drawSurfaces(
    target: Target,
    name: "room" | "candle",
    normals: Normals,
    uWorldFromModel: readonly number[],
  ): void {
    for (const mesh of this.#models[name]) {
      const { vertexArray, textures, uniforms } = mesh;
      this.#gpu.draw({
        program: this.#surfaceProgram(name, normals, mesh),
        target,
        vertexArray,
        textures,
        sampling: this.#isFiltered ? LEVELS : surfaceSampling(this.#tier),
        uniforms: { ...uniforms, uWorldFromModel, uCodesEdges: this.#isFiltered ? 1 : 0 },
        blocks: { Frame: this.#frame, Light: this.#light },
        depth: "test-and-write",
        cull: mesh.isDoubleSided ? "none" : "back",
      });
    }
  }

  #drawParticles(
    target: Target,
    world: World,
    features: Features,
    { clipFromWorld, projectionScale }: ReturnType<typeof frameBlock>,
  ): void {
    const { setup, interpolated, look, remainder } = world;
    const isFinal = look === "paper";
    const hasGradient = isFinal && features.gradient;
    const clipFromFlame = mat4.translate(mat4.create(), clipFromWorld, interpolated.flame);
    const { flameScale } = setup;
    mat4.scale(clipFromFlame, clipFromFlame, [flameScale, flameScale, flameScale]);
    for (const system of this.#systems) {
      const { size } = system.layer;
      const name = system.layer.name === "haze" ? "haze" : "core";
      if (name === "haze" ? !features.hazeLayer : !features.core) {
        system.follow(world.timeline);
        continue;
      }
      system.draw(world.timeline, {
        program: this.#program("particle", {
          HAZE: Number(name === "haze"),
          GRADIENT: Number(hasGradient),
        }),
        target,
        uniforms: {
          uClipFromFlame: new Float32Array(clipFromFlame),
          uSize: size * (flameScale * projectionScale),
          uExtrapolation: remainder,
          uFading: isFinal ? 1 : 0,
          uGlow: hasGradient ? GLOW[name] : FLAT_GLOW[name],
        },
        blend: "premultiplied",
        depth: "test",
        cull: "none",
      });
    }
  }

  /** There is no HDR buffer: the canvas is decoded, and its exposure undone. */
  readRadiance([x, y, width, height]: Box): Float32Array {
    const bytes = this.#gpu.readCanvas([x, this.#size.height - y - height, width, height]);
    const radiance = new Float32Array(width * height * 3);
    for (let row = 0; row < height; row++) {
      for (let column = 0; column < width; column++) {
        const from = ((height - 1 - row) * width + column) * 4;
        for (let channel = 0; channel < 3; channel++) {
          const linear = decodeSrgb((bytes[from + channel] ?? 0) / 255);
          radiance[(row * width + column) * 3 + channel] = linear / this.#exposure;
        }
      }
    }
    return radiance;
  }
}

/** IEC 61966-2-1. */
function decodeSrgb(value: number): number {
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
}
