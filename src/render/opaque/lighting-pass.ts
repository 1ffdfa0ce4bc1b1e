import { mat4 } from "gl-matrix";
import gatherFrag from "../../../shaders/opaque/gather-inverse-depth.frag";
import lightingFrag from "../../../shaders/opaque/lighting.frag";
import fullscreenVert from "../../../shaders/post/fullscreen.vert";
import type { Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { RenderTarget } from "../../gl/render-target.js";
import type { Texture, TextureFormat } from "../../gl/texture.js";
import type { UniformBlock } from "../../gl/uniform-block.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import { floats } from "../float-format.js";
import type { FrameInput, Size } from "../frame-input.js";
import type { GBuffer } from "../gbuffer/gbuffer.js";
import type { IrradianceVolume } from "../gi/indirect-pass.js";
import { shadingLight } from "../light-block.js";
import type { ShadowQuality } from "../quality.js";
import { SCHEDULE } from "../schedule.js";
import type { ShadowCube } from "../shadow/shadow-pass.js";
import type { OpaqueLayer } from "./opaque-stage.js";

/** Lighting texels along an edge for each pixel, by kind of the G-buffer. */
const RATE = { reduced: 0.2, full: 0.5 } as const;

/** Deferred lighting at a lower rate than the G-buffer's: direct and indirect, for each candela of the flame's. */
export class LightingPass {
  readonly format: TextureFormat;
  readonly frame: UniformBlock;
  readonly light: UniformBlock;
  readonly #gpu: Gpu;
  readonly #screen: VertexArray;
  readonly #shadowQuality: ShadowQuality;
  readonly #full: Program;
  /** Of the reduced lighting; made when it is first needed. */
  #reduced: Program | null = null;
  readonly #gather: Program;
  /** The flame that the lighting is of. */
  readonly #shadingLight: UniformBlock;
  #key = "";
  #fullTarget: RenderTarget | null = null;
  #reducedTarget: RenderTarget | null = null;
  /** Inverse depths of four neighbours in each texel, for the bilateral upsampling. */
  #gathered: RenderTarget | null = null;

  constructor(gpu: Gpu, screen: VertexArray, quality: ShadowQuality) {
    this.#gpu = gpu;
    this.#screen = screen;
    this.#shadowQuality = quality;
    this.#full = this.#program(quality, 0);
    this.#gather = gpu.program("opaque/gather-inverse-depth", fullscreenVert, gatherFrag);
    this.format = floats(gpu, 4);
    this.frame = gpu.uniformBlock(this.#full, "Frame");
    this.light = this.newLightBlock();
    this.#shadingLight = this.newLightBlock();
  }

  newLightBlock(): UniformBlock {
    return this.#gpu.uniformBlock(this.#full, "Light");
  }

  #program({ search, taps, bias }: ShadowQuality, REDUCED: 0 | 1): Program {
    const defines = { SHADOW_SEARCH: search, SHADOW_TAPS: taps, SHADOW_BIAS: bias, REDUCED };
    return this.#gpu.program("opaque/lighting", fullscreenVert, lightingFrag, { defines });
  }

  /** Compiles, while the camera rests, what its first motion needs. */
  prepareReduced(): Program {
    const { search, taps } = this.#shadowQuality;
    // Texels four times as large are averaged over as many shadow taps again.
    const half = {
      ...this.#shadowQuality,
      search: Math.ceil(search / 2),
      taps: Math.ceil(taps / 2),
    };
    this.#reduced ??= this.#program(half, 1);
    return this.#reduced;
  }

  /** Of lighting by a flame. */
  programOf(isReduced: boolean): Program {
    return isReduced ? this.prepareReduced() : this.#full;
  }

  resize({ width, height }: Size): void {
    for (const old of [this.#reducedTarget, this.#fullTarget, this.#gathered]) old?.dispose();
    const target = (
      kind: keyof typeof RATE,
      color: readonly TextureFormat[],
      name: string = kind,
      filter: "nearest" | "linear" = "linear",
    ) =>
      this.#gpu.renderTarget({
        label: `lighting/${name}`,
        width: Math.max(1, Math.ceil(width * RATE[kind])),
        height: Math.max(1, Math.ceil(height * RATE[kind])),
        color,
        filter,
      });
    this.#reducedTarget = target("reduced", [this.format, floats(this.#gpu, 1)]);
    this.#gathered = target("reduced", [this.format], "gathered", "nearest");
    this.#fullTarget = target("full", [this.format]);
    this.#key = "";
  }

  /** Texels of the full lighting. */
  get size(): Size {
    return this.#fullTarget ?? { width: 1, height: 1 };
  }

  render(
    frame: FrameInput,
    { kind, surface, depth, representative, key: gbufferKey, reprojection }: GBuffer,
    shadow: ShadowCube,
    irradiance: IrradianceVolume,
  ): Pick<OpaqueLayer, "uniforms"> & { readonly textures: { readonly uLighting: Texture } } {
    const isReduced = kind !== "full";
    const target = isReduced ? this.#reducedTarget : this.#fullTarget;
    const { support } = irradiance;
    if (!target || !this.#gathered) throw new Error("Lighting has no size yet.");
    const textures = {
      uLighting: target.color,
      ...(isReduced && { uInverseDepthGather: this.#gathered.color }),
    };
    if (reprojection) {
      // The previous frame's lighting is reprojected with its G-buffer.
      const uniforms = {
        uPreviousFromCurrentRoom: reprojection.room as Float32Array,
        uPreviousFromCurrentHeld: reprojection.held as Float32Array,
      };
      return { textures, uniforms };
    }
    const { shadows, indirect, specular, candle } = frame.settings.features;
    const light = {
      ...shadingLight(frame.world, candle, SCHEDULE.lighting.deferred),
      captureOrigin: shadow.captureOrigin,
    };
    const key = JSON.stringify([gbufferKey, light, shadows, indirect, specular]);
    if (key === this.#key) return { textures, uniforms: {} };
    this.#key = key;
    this.#shadingLight.update(light);
    const worldFromClip = mat4.invert(mat4.create(), frame.clipFromWorld);
    if (!worldFromClip) throw new Error("The camera's matrix has no inverse.");
    this.#gpu.draw({
      program: isReduced ? this.prepareReduced() : this.#full,
      target,
      vertexArray: this.#screen,
      textures: {
        uGBufferSurface: surface,
        uDepth: depth,
        ...(representative && { uRepresentative: representative }),
        uShadow: shadow.depth,
        ...irradiance.textures,
        uSupport: support,
      },
      uniforms: {
        uFeatures: [shadows, indirect, specular].map(Number),
        uLightingSize: [target.width, target.height],
        uWorldFromClip: worldFromClip as Float32Array,
      },
      blocks: { Frame: this.frame, Light: this.#shadingLight, Volume: irradiance.block },
    });
    if (isReduced) this.#gatherInverseDepth(target, this.#gathered);
    return { textures, uniforms: {} };
  }

  #gatherInverseDepth({ colors: [, uInverseDepth] }: RenderTarget, target: RenderTarget): void {
    if (!uInverseDepth) throw new Error("Reduced lighting has a texture of inverse depth.");
    this.#gpu.draw({
      program: this.#gather,
      target,
      vertexArray: this.#screen,
      textures: { uInverseDepth },
    });
  }
}
