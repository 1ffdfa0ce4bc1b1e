import bounceLimitFrag from "../../../shaders/gi/bounce-limit.frag";
import irradianceFrag from "../../../shaders/gi/irradiance.frag";
import fullscreenVert from "../../../shaders/post/fullscreen.vert";
import type { Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { RenderTarget } from "../../gl/render-target.js";
import type { Texture, TextureFormat } from "../../gl/texture.js";
import type { UniformBlock } from "../../gl/uniform-block.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import type { Size } from "../frame-input.js";
import { IRRADIANCE_EDGE, IRRADIANCE_TEXELS } from "./probe-rays.js";

/** Octahedral maps of all probes' irradiance, with borders, for filtered reads: `lib/irradiance-volume.glsl`. */
export class IrradianceAtlas {
  readonly #gpu: Gpu;
  readonly #screen: VertexArray;
  readonly #volume: UniformBlock;
  readonly #programs: readonly [plain: Program, extrapolated: Program];
  readonly #limitProgram: Program;
  readonly #weights: RenderTarget;
  readonly #irradiance: RenderTarget;

  /** @param tiles probes along each axis of the atlas */
  constructor(
    gpu: Gpu,
    screen: VertexArray,
    volume: UniformBlock,
    tiles: Size,
    format: TextureFormat,
  ) {
    this.#gpu = gpu;
    this.#screen = screen;
    this.#volume = volume;
    const program = (EXTRAPOLATED: 0 | 1) =>
      gpu.program("gi/irradiance", fullscreenVert, irradianceFrag, {
        defines: { EXTRAPOLATED, IRRADIANCE_TEXELS },
      });
    this.#programs = [program(0), program(1)];
    this.#limitProgram = gpu.program("gi/bounce-limit", fullscreenVert, bounceLimitFrag, {
      defines: { IRRADIANCE_TEXELS },
    });
    this.#weights = gpu.renderTarget({
      label: "gi/bounce-limit",
      width: 1,
      height: 1,
      color: ["RGBA16F", "RGBA16F"],
      filter: "nearest",
    });
    this.#irradiance = gpu.renderTarget({
      label: "gi/irradiance",
      width: tiles.width * IRRADIANCE_EDGE,
      height: tiles.height * IRRADIANCE_EDGE,
      color: [format],
    });
  }

  /** The irradiance atlas, lx for a flame of 1 cd. */
  get irradiance(): Texture {
    return this.#irradiance.color;
  }

  render(maps: RenderTarget): void {
    this.#draw(this.#programs[0], { uLast: maps.color });
  }

  /** The same after all bounces, extrapolated from four sums of the series in a row. */
  renderLimit([first, before, previous, last]: readonly RenderTarget[]): void {
    if (!first || !before || !previous || !last) throw new Error("A limit takes four sums.");
    const textures = { uLast: last.color, uPrevious: previous.color, uBefore: before.color };
    this.#gpu.draw({
      program: this.#limitProgram,
      target: this.#weights,
      vertexArray: this.#screen,
      textures: { ...textures, uFirst: first.color },
    });
    const [uPreviousWeight, uBeforeWeight] = this.#weights.colors;
    this.#draw(this.#programs[1], {
      ...textures,
      uPreviousWeight: uPreviousWeight!,
      uBeforeWeight: uBeforeWeight!,
    });
  }

  #draw(program: Program, textures: Readonly<Record<string, Texture>>): void {
    const blocks = { Volume: this.#volume };
    this.#gpu.draw({
      program,
      target: this.#irradiance,
      vertexArray: this.#screen,
      textures,
      blocks,
    });
  }
}
