import { mat4 } from "gl-matrix";
import cornersFrag from "../../../shaders/opaque/gather-nearness.frag";
import lightFrag from "../../../shaders/opaque/lighting.frag";
import fullscreenVert from "../../../shaders/post/fullscreen.vert";
import type { Gpu } from "../../gl/gpu.js";
import type { Program, UniformValue } from "../../gl/program.js";
import type { RenderTarget } from "../../gl/render-target.js";
import type { Texture, TextureFormat } from "../../gl/texture.js";
import type { UniformBlock } from "../../gl/uniform-block.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import type { Features } from "../../settings.js";
import { floats } from "../float-format.js";
import type { Paint } from "../gbuffer/gbuffer.js";
import type { IrradianceVolume } from "../gi/indirect-pass.js";
import type { CaptureLight } from "../light-block.js";

/** Texels along an edge of the light for each pixel of the picture, while the eye moves and when it rests. */
const SHARE = { moving: 0.2, resting: 0.5 } as const;

/** Looks at the shadow cube for each texel. */
export interface ShadowQuality {
  readonly search: number;
  readonly taps: number;
}

/** What shaders read that include `lib/composite.glsl`. */
export interface Lit {
  readonly textures: Readonly<Record<string, Texture>>;
  /** For paint that was kept: from places in the picture to those in the one that paint and light are of. */
  readonly uniforms: Readonly<Record<string, UniformValue>>;
}

/** Light on the surfaces in sight, direct and bounced, coarser than they are. */
export class LightingPass {
  readonly format: TextureFormat;
  readonly frame: UniformBlock;
  readonly light: UniformBlock;
  readonly #gpu: Gpu;
  /** The flame as the light was worked out for. */
  readonly #lamp: UniformBlock;
  #known = "";
  readonly #program: Program;
  readonly #taps: ShadowQuality;
  /** For light of which there are few texels; made when it is first needed. */
  #coarse: Program | null = null;
  readonly #screen: VertexArray;
  /** What shaders compare the texels of coarse light by. */
  readonly #corner: Program;
  #corners: RenderTarget | null = null;
  #moving: RenderTarget | null = null;
  #resting: RenderTarget | null = null;

  constructor(gpu: Gpu, screen: VertexArray, taps: ShadowQuality) {
    this.#gpu = gpu;
    this.#screen = screen;
    this.#taps = taps;
    this.#program = this.#programOf(taps, 0);
    this.#corner = gpu.program("opaque/gather-nearness", fullscreenVert, cornersFrag);
    this.format = floats(gpu, 4);
    this.frame = gpu.uniformBlock(this.#program, "Frame");
    this.light = gpu.uniformBlock(this.#program, "Light");
    this.#lamp = gpu.uniformBlock(this.#program, "Light");
  }

  #programOf({ search, taps }: ShadowQuality, COARSE: 0 | 1): Program {
    const defines = { SHADOW_SEARCH: search, SHADOW_TAPS: taps, COARSE };
    return this.#gpu.program("opaque/lighting", fullscreenVert, lightFrag, { defines });
  }

  /** Has the light of a moving eye compiled before it moves. */
  prepareMotion(): void {
    this.#coarseProgram();
  }

  #coarseProgram(): Program {
    this.#coarse ??= this.#programOf(halfOf(this.#taps), 1);
    return this.#coarse;
  }

  resize(width: number, height: number): void {
    for (const old of [this.#moving, this.#resting, this.#corners]) old?.dispose();
    const target = (name: keyof typeof SHARE, color: readonly TextureFormat[]) =>
      this.#gpu.renderTarget({
        label: `light/${name}`,
        width: Math.max(1, Math.ceil(width * SHARE[name])),
        height: Math.max(1, Math.ceil(height * SHARE[name])),
        color,
      });
    const moving = target("moving", [this.format, floats(this.#gpu, 1)]);
    this.#moving = moving;
    this.#corners = this.#gpu.renderTarget({
      label: "light/corners",
      width: moving.width,
      height: moving.height,
      color: [this.format],
      filter: "nearest",
    });
    this.#resting = target("resting", [this.format]);
    this.#known = "";
  }

  /** Texels of the light of an eye that rests. */
  get size(): { readonly width: number; readonly height: number } {
    return this.#resting ?? { width: 1, height: 1 };
  }

  /**
   * Factors on the paint and what is added to it, for each cd of the flame's.
   *
   * @param lamp members of the block of `lib/flame-light.glsl`; the light stays while they do
   */
  render(
    { kind, surfaces, depth, usual, known: paint, since }: Paint,
    lamp: CaptureLight,
    shadow: Texture,
    volume: IrradianceVolume,
    clip: mat4,
    { shadows, indirect, specular }: Features,
  ): Lit {
    const isCoarse = kind !== "fine";
    const target = isCoarse ? this.#moving : this.#resting;
    if (!target) throw new Error("Light has no size yet.");
    const { color: uLight } = target;
    const { support } = volume;
    if (!support) throw new Error("Few probes need to be told what is below the flame.");
    const corners = isCoarse && this.#corners ? { uNearnessGather: this.#corners.color } : {};
    const textures = { uLight, ...corners };
    // What was lit a picture ago goes with its paint.
    if (since) {
      const uniforms = {
        uPreviousFromCurrentRoom: since.room as Float32Array,
        uPreviousFromCurrentHeld: since.carried as Float32Array,
      };
      return { textures, uniforms };
    }
    const lit = { textures, uniforms: {} };
    const known = JSON.stringify([paint, lamp, shadows, indirect, specular]);
    if (known === this.#known) return lit;
    this.#known = known;
    this.#lamp.update(lamp);
    const worldFromClip = mat4.invert(mat4.create(), clip);
    if (!worldFromClip) throw new Error("The eye sees nothing.");
    this.#gpu.draw({
      program: isCoarse ? this.#coarseProgram() : this.#program,
      target,
      vertexArray: this.#screen,
      textures: {
        uGBufferSurface: surfaces,
        uDepth: depth,
        ...(usual && { uRepresentative: usual }),
        uShadow: shadow,
        ...volume.textures,
        uSupport: support,
      },
      uniforms: {
        uShown: [shadows ? 1 : 0, indirect ? 1 : 0, specular ? 1 : 0],
        uSize: [target.width, target.height],
        uWorldFromClip: worldFromClip as Float32Array,
      },
      blocks: { Frame: this.frame, Light: this.#lamp, Volume: volume.block },
    });
    if (isCoarse) this.#findCorners(target);
    return lit;
  }

  #findCorners({ colors: [, uNearness] }: RenderTarget): void {
    if (!uNearness || !this.#corners) throw new Error("Coarse light says how near it is.");
    this.#gpu.draw({
      program: this.#corner,
      target: this.#corners,
      vertexArray: this.#screen,
      textures: { uNearness },
    });
  }
}

/** Texels four times as large are mixed of as many looks again. */
function halfOf({ search, taps }: ShadowQuality): ShadowQuality {
  return { search: Math.ceil(search / 2), taps: Math.ceil(taps / 2) };
}
