import { mat4 } from "gl-matrix";
import moonFrag from "../../../shaders/opaque/moon-lighting.frag";
import sumFrag from "../../../shaders/opaque/sum-lighting.frag";
import type {
  Gpu,
  Program,
  RenderTarget,
  Texture,
  TextureFormat,
  UniformBlock,
} from "../../gl/gpu.js";
import { luma, type Rgb } from "../../light/color.js";
import { TAPER } from "../../light/flame-light.js";
import type { Steps } from "../../world/steps.js";
import type { CachedLight } from "../cached-light.js";
import type { FrameInput, Size } from "../frame-input.js";
import type { GBuffer } from "../gbuffer/gbuffer.js";
import { lightBlock } from "../light-block.js";
import type { ShadowQuality } from "../quality.js";
import type { FrameBlocks } from "./opaque-stage.js";

/** Least intensity by which the sum has the flame's colour, cd: an ember gives less. */
const BURNING = 0.01;

/** Colour of the light that represents all: the flames', or the moon's where none burns. Its luma is 1. */
export function representativeColor(flame: Rgb, lights: readonly CachedLight[]): Rgb {
  const burning = lights.some(
    ({ kind, intensity }) => kind === "candle" && luma(intensity) > BURNING,
  );
  if (burning || luma(flame) > BURNING) return TAPER.color;
  const [{ intensity } = { intensity: flame }] = lights;
  const scale = Math.max(luma(intensity), 1e-9);
  return [intensity[0] / scale, intensity[1] / scale, intensity[2] / scale];
}

/** What all deferred lighting reads, at one of its sizes. */
export function lightingInputs(
  { settings, clipFromWorld }: FrameInput,
  { surface, depth, albedo, representative }: GBuffer,
  { width, height }: Size,
) {
  const worldFromClip = mat4.invert(mat4.create(), clipFromWorld)!;
  const { shadows, indirect, specular } = settings.features;
  return {
    textures: {
      uGBufferSurface: surface,
      uGBufferAlbedo: albedo,
      uDepth: depth,
      ...(representative && { uRepresentative: representative }),
    },
    uniforms: {
      uFeatures: [shadows, indirect, specular].map(Number),
      uLightingSize: [width, height],
      uWorldFromClip: worldFromClip as Float32Array,
    },
  };
}

/** Program of lighting by the moon. */
export function moonLighting(gpu: Gpu, { search, taps }: ShadowQuality, REDUCED: 0 | 1): Program {
  const defines = { SHADOW_SEARCH: search, SHADOW_TAPS: taps, REDUCED };
  return gpu.pass("opaque/moon-lighting", moonFrag, { defines });
}

/** Deferred lighting at rest by cached lights, each in a texture of its own, and their sum with the flame's. */
export class CachedLighting {
  readonly #gpu: Gpu;
  readonly #moonShadow: ShadowQuality;
  readonly #format: TextureFormat;
  /** By the light's name. */
  readonly #layers = new Map<string, { readonly target: RenderTarget; key: string }>();
  /** Sums, used in turn; the last one written is first. */
  #sums: [RenderTarget, RenderTarget] | null = null;
  /** The light whose lighting the sum is. */
  readonly #block: UniformBlock;

  readonly #frame: UniformBlock;
  readonly #flameProgram: Program;

  /**
   * @param blocks `Frame`, and a `Light` for the sum
   * @param flameProgram of lighting by a flame
   */
  constructor(
    gpu: Gpu,
    quality: ShadowQuality,
    format: TextureFormat,
    { Frame, Light }: FrameBlocks,
    flameProgram: Program,
  ) {
    this.#flameProgram = flameProgram;
    this.#gpu = gpu;
    // It is lit once, and its penumbra is next to black.
    this.#moonShadow = { ...quality, search: 3 * quality.search, taps: 3 * quality.taps };
    this.#format = format;
    this.#frame = Frame;
    this.#block = Light;
  }

  /** Frees what it drew to, which is of the frame's size. */
  release(): void {
    for (const { target } of this.#layers.values()) target.dispose();
    for (const sum of this.#sums ?? []) sum.dispose();
    this.#layers.clear();
    this.#sums = null;
  }

  /**
   * The lighting of all lights, and the block of the light that it is per candela of.
   *
   * @param lighting of the flame
   */
  *render(
    frame: FrameInput,
    gbuffer: GBuffer,
    lighting: Texture,
    lights: readonly CachedLight[],
  ): Steps<{ readonly uLighting: Texture; readonly Light: UniformBlock }> {
    const size = { width: lighting.width, height: lighting.height };
    this.#sums ??= [this.#target("sum/a", size), this.#target("sum/b", size)];
    const sums = this.#sums;
    for (const [name, { target }] of this.#layers) {
      if (lights.some((light) => light.name === name)) continue;
      target.dispose();
      this.#layers.delete(name);
    }
    const flame = lightBlock(frame.world, frame.settings.features.candle);
    const uColor = representativeColor(flame.intensity, lights);
    let uLighting = lighting;
    let uIntensity: Rgb = flame.intensity;
    for (const light of lights) {
      yield;
      const uCachedLighting = yield* this.#layerOf(light, frame, gbuffer, size);
      sums.reverse();
      this.#gpu.draw({
        program: this.#gpu.pass("opaque/sum-lighting", sumFrag),
        target: sums[0],
        textures: { uLighting, uCachedLighting },
        uniforms: { uIntensity, uCachedIntensity: light.intensity, uColor },
      });
      uLighting = sums[0].color;
      uIntensity = uColor;
    }
    this.#block.update({ ...flame, intensity: uColor });
    return { uLighting, Light: this.#block };
  }

  #target(name: string, size: Size): RenderTarget {
    return this.#gpu.renderTarget({ label: `lighting/${name}`, ...size, color: [this.#format] });
  }

  /** The lighting by one light, which stays until camera, models or the light have moved. */
  *#layerOf(light: CachedLight, frame: FrameInput, gbuffer: GBuffer, size: Size): Steps<Texture> {
    const known = this.#layers.get(light.name);
    const layer = known ?? { target: this.#target(light.name, size), key: "" };
    this.#layers.set(light.name, layer);
    const { shadows, indirect, specular } = frame.settings.features;
    const key = JSON.stringify([gbuffer.key, light.key, shadows, indirect, specular]);
    if (layer.key === key) return layer.target.color;
    layer.key = key;
    const { textures, uniforms } = lightingInputs(frame, gbuffer, size);
    const isMoon = light.kind === "moon";
    this.#gpu.draw({
      program: isMoon ? moonLighting(this.#gpu, this.#moonShadow, 0) : this.#flameProgram,
      target: layer.target,
      textures: {
        ...textures,
        [isMoon ? "uMoonMap" : "uShadow"]: light.shadow,
        uSupport: light.irradiance.support,
        ...light.irradiance.surfels,
        ...light.irradiance.textures,
      },
      uniforms,
      blocks: {
        Frame: this.#frame,
        [isMoon ? "Moon" : "Light"]: light.block,
        Volume: light.irradiance.block,
      },
    });
    yield;
    return layer.target.color;
  }
}
