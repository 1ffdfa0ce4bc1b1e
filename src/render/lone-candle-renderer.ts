import type { mat4 } from "gl-matrix";
import displayFrag from "../../shaders/candle/display.frag";
import surfaceFrag from "../../shaders/candle/surface.frag";
import surfaceVert from "../../shaders/mesh/mesh.vert";
import fullscreenVert from "../../shaders/post/fullscreen.vert";
import type { Model } from "../assets/model.js";
import type { Box, Gpu } from "../gl/gpu.js";
import type { Program } from "../gl/program.js";
import type { RenderTarget } from "../gl/render-target.js";
import type { UniformBlock } from "../gl/uniform-block.js";
import { adaptation, adaptedWhite, luma, VIBRANCE } from "../light/color.js";
import { carriedFlame, emberRadiance, flameLight, TAPER } from "../light/flame-light.js";
import { nightVision } from "../light/night-vision.js";
import type { Vec3 } from "../world/geometry.js";
import type { World } from "../world/world.js";
import { clipFromWorld, clipPosition, projectionScale } from "./camera.js";
import type { FrameSettings } from "./frame-settings.js";
import { lightBlock } from "./light-block.js";
import { frameCandle } from "./lone-candle-framing.js";
import { type Mesh, surfaceSampling, uploadModel } from "./mesh/mesh.js";
import type { Tier } from "./quality.js";
import type { Renderer } from "./renderer.js";
import { carriedWick, FlamePass, HANDLE_TURN } from "./volumetric/flame-pass.js";
import type { SmokePass } from "./volumetric/smoke-pass.js";

/** From cd/m² to the display's scale. */
const EXPOSURE = 5;
const NOTHING = [0, 0, 0, 0] as const;
const NO_EMBER = [0, 0, 0] as const;

/** GPU objects shared by all lone candles on one context. */
interface Shared {
  readonly surfaceProgram: Program;
  readonly displayProgram: Program;
  readonly frame: UniformBlock;
  readonly light: UniformBlock;
  readonly flame: FlamePass;
  readonly candle: readonly Mesh[];
}

const sharedByGpu = new WeakMap<Gpu, Shared>();

function share(gpu: Gpu, model: Model): Shared {
  const surfaceProgram = gpu.program("candle/surface", surfaceVert, surfaceFrag);
  const shared: Shared = {
    surfaceProgram,
    displayProgram: gpu.program("candle/display", fullscreenVert, displayFrag),
    frame: gpu.uniformBlock(surfaceProgram, "Frame"),
    light: gpu.uniformBlock(surfaceProgram, "Light"),
    flame: new FlamePass(gpu),
    candle: uploadModel(gpu, model),
  };
  sharedByGpu.set(gpu, shared);
  return shared;
}

/**
 * The candle and its flame with alpha, over the page's background.
 *
 * It draws to the lower left corner of a canvas that it may share with others.
 */
export class LoneCandleRenderer implements Renderer {
  readonly particles = 0;
  readonly #gpu: Gpu;
  readonly #tier: Tier;
  readonly #shared: Shared;
  readonly #smokePass: (gpu: Gpu) => SmokePass | null;
  readonly #adaptation = adaptation(TAPER.color);
  #samples: RenderTarget | null = null;
  #radiance: RenderTarget | null = null;
  #size = { width: 1, height: 1 };

  /** @param smokePass null until its code is there */
  constructor(gpu: Gpu, model: Model, tier: Tier, smokePass: (gpu: Gpu) => SmokePass | null) {
    this.#smokePass = smokePass;
    this.#gpu = gpu;
    this.#tier = tier;
    this.#shared = sharedByGpu.get(gpu) ?? share(gpu, model);
  }

  resize(width: number, height: number): void {
    const { samples } = this.#tier;
    this.dispose();
    this.#size = { width, height };
    const size = { width, height, color: ["RGBA16F"] as const, depth: "buffer" as const };
    this.#samples =
      samples > 1 ? this.#gpu.renderTarget({ label: "candle/samples", ...size, samples }) : null;
    this.#radiance = this.#gpu.renderTarget({ label: "candle/radiance", ...size });
  }

  /** The flame has no particles. */
  setLayers(): void {}

  render(world: World, { features, exposure }: FrameSettings): void {
    if (!this.#radiance) return;
    const { frame, light, flame, displayProgram } = this.#shared;
    const target = this.#samples ?? this.#radiance;
    const { width, height } = this.#size;
    const { eye, pitch, fieldOfView } = frameCandle(width / height, world.flame.wick);
    const clip = clipFromWorld(eye, 0, pitch, width / height, fieldOfView);
    frame.update({
      clipFromWorld: clip,
      eyePosition: eye,
      exposure: EXPOSURE * 2 ** exposure,
      viewport: [width, height],
      projectionScale: projectionScale(height),
      normalMaps: features.normalMaps ? 1 : 0,
    });
    light.update(lightBlock(world, features.candle));
    this.#gpu.clear(target, NOTHING);
    if (features.candle) this.#drawCandle(target, world);
    flame.render(target, frame, carriedWick(world), this.#tier.physical.flameSteps);
    if (features.smoke) {
      const uniforms = { uEnvironment: TAPER.color };
      this.#smokePass(this.#gpu)?.render(world, clip, {
        target,
        uniforms,
        blocks: { Frame: frame },
      });
    }
    if (this.#samples) this.#gpu.resolve(this.#samples, this.#radiance);
    const { position, halfHeight, intensity } = flameLight(carriedFlame(world), TAPER);
    const [x, y] = canvasUv(clip, position);
    const [, top] = canvasUv(clip, [position[0], position[1] + halfHeight, position[2]]);
    const candela = luma(intensity);
    const { contrast, rods } = nightVision(0);
    this.#gpu.draw({
      program: displayProgram,
      target: "canvas",
      viewport: [0, 0, width, height],
      textures: { uRadiance: this.#radiance.color },
      uniforms: {
        uAdaptation: this.#adaptation,
        uWhite: adaptedWhite(),
        uVibrance: VIBRANCE,
        uRods: rods,
        uContrast: contrast,
        uGlare: [x, y, Math.abs(top - y), features.bloom ? Math.min(candela, 2) * 0.55 : 0],
        uGlareColor: [1, 0.72, 0.36],
      },
      blocks: { Frame: frame },
    });
  }

  #drawCandle(target: RenderTarget, world: World): void {
    const { surfaceProgram, candle, frame, light } = this.#shared;
    const [x, y, z] = world.interpolated.foot;
    const ember = emberRadiance(world.flame.ember);
    for (const surface of candle) {
      this.#gpu.draw({
        program: surfaceProgram,
        target,
        vertexArray: surface.vertexArray,
        textures: surface.textures,
        sampling: surfaceSampling({ anisotropy: true }),
        uniforms: {
          uBaseColor: surface.baseColor,
          uEnvironment: TAPER.color,
          uPlacement: [x, y, z, HANDLE_TURN],
          uSurface: surface.parameters,
          uOcclusionStrength: surface.occlusionStrength,
          uWax: surface.isWax ? 1 : 0,
          uEmber: surface.isWick ? ember : NO_EMBER,
        },
        blocks: { Frame: frame, Light: light },
        depth: "test-and-write",
        cull: surface.isDoubleSided ? "none" : "back",
      });
    }
  }

  readRadiance(box: Box): Float32Array {
    return this.#gpu.readFloats(this.#radiance!, box);
  }

  /** Frees the targets; all else is shared. */
  dispose(): void {
    this.#samples?.dispose();
    this.#radiance?.dispose();
    this.#samples = null;
    this.#radiance = null;
  }
}

/** uv on the canvas of a point in world space. */
function canvasUv(clip: mat4, [x, y, z]: Vec3): readonly [number, number] {
  const [across, up, w] = clipPosition(clip, x, y, z);
  return [0.5 + (0.5 * across) / w, 0.5 + (0.5 * up) / w];
}
