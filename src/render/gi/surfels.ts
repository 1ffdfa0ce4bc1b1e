import radiosityFrag from "../../../shaders/gi/radiosity.frag";
import surfelFrag from "../../../shaders/gi/surfel.frag";
import cubeFaceVert from "../../../shaders/shadow/cube-face.vert";
import type {
  Draw,
  Gpu,
  Program,
  RenderTarget,
  Texture,
  TextureFormat,
  UniformBlock,
} from "../../gl/gpu.js";
import type { Bounds, Vec3 } from "../../world/geometry.js";
import { floats } from "../float-format.js";
import type { CaptureLight } from "../light-block.js";
import { FACES } from "../shadow/cube-map.js";
import type { ShadowCasters } from "../shadow/shadow-casters.js";

/** Surfels, captured and lit by a flame or by the moon, which has neither a support nor reflections of all its light. */
export abstract class Surfels {
  /** Of the light, and by its name. */
  readonly block: UniformBlock;
  readonly blocks: Readonly<Record<string, UniformBlock>>;
  /** Of shaders that write or read the surfels. */
  readonly defines: Readonly<Record<string, number>>;
  protected readonly gpu: Gpu;
  protected readonly size: number;
  readonly #captureProgram: Program;
  readonly #radiosityProgram: Program;
  readonly #surfels: RenderTarget;
  readonly #radiosity: RenderTarget;

  /**
   * @param size rows of surfels; there are as many columns as six times that
   * @param light name of its block
   */
  constructor(gpu: Gpu, size: number, light: "Light" | "Moon") {
    this.gpu = gpu;
    this.size = size;
    this.defines = light === "Moon" ? { MOON: 1 } : {};
    const options = { defines: this.defines };
    this.#captureProgram = gpu.program("gi/surfel", cubeFaceVert, surfelFrag, options);
    this.#radiosityProgram = gpu.pass("gi/radiosity", radiosityFrag, options);
    this.block = gpu.uniformBlock(this.#radiosityProgram, light);
    this.blocks = { [light]: this.block };
    const texel = floats(gpu, 4);
    this.#surfels = this.target(`gi/surfels/${light}`, [texel, texel], "buffer");
    this.#radiosity = this.target(`gi/radiosity/${light}`);
  }

  protected target(
    label: string,
    color: readonly TextureFormat[] = ["RGBA16F"],
    depth: "none" | "buffer" = "none",
  ): RenderTarget {
    const size = { width: this.size * FACES.length, height: this.size };
    return this.gpu.renderTarget({ label, ...size, color, depth, filter: "nearest" });
  }

  /** Captures a face of the cube around a flame, of six. */
  abstract capture(casters: ShadowCasters, captureOrigin: Vec3, face: number): void;

  protected draw(
    casters: ShadowCasters,
    draw: Required<Pick<Draw, "viewport" | "uniforms">>,
    isVisible: (box: Bounds) => boolean,
  ): void {
    // What no capture draws to, as the moon's rows on the panes, is zero since WebGL created it.
    this.gpu.clear(this.#surfels, [0, 0, 0, 0], draw.viewport);
    const pass = { program: this.#captureProgram, target: this.#surfels, ...draw };
    casters.drawWithAlbedo({ ...pass, depth: "test-and-write", cull: "none" }, isVisible);
  }

  /** Which of them each probe sees, where that was traced. */
  get visibility(): { readonly uSurfelVisibility?: Texture } {
    return {};
  }

  /** Normal, and distance from the capture origin. */
  get normalDistance(): Texture {
    return this.textures.uSurfelNormalDistance;
  }

  /** In direct light, lm/m². */
  get radiosity(): Texture {
    return this.#radiosity.color;
  }

  /** In all light, lm/m². */
  get totalRadiosity(): Texture {
    return this.radiosity;
  }

  /** Of the surface below the flame, for `lib/support-irradiance.glsl`. */
  get support(): Texture {
    return this.radiosity;
  }

  /** Radiosity by a light. */
  renderRadiosity(light: CaptureLight): void {
    this.block.update(light);
    const { blocks, textures } = this;
    this.gpu.draw({ program: this.#radiosityProgram, target: this.#radiosity, textures, blocks });
  }

  /** The same with indirect light, by the irradiance volume. */
  renderTotalRadiosity(_volume: Readonly<Record<string, Texture>>, _block: UniformBlock): void {}

  protected get textures() {
    const [uSurfelReflectance, uSurfelNormalDistance] = this.#surfels.colors;
    return {
      uSurfelReflectance: uSurfelReflectance!,
      uSurfelNormalDistance: uSurfelNormalDistance!,
    };
  }
}
