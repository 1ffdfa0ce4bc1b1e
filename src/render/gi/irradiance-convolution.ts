import bounceTailFrag from "../../../shaders/gi/bounce-tail.frag";
import irradianceFrag from "../../../shaders/gi/irradiance.frag";
import fullscreenVert from "../../../shaders/post/fullscreen.vert";
import type { Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { RenderTarget } from "../../gl/render-target.js";
import type { Texture, TextureFormat } from "../../gl/texture.js";
import type { UniformBlock } from "../../gl/uniform-block.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import type { Size } from "../frame-input.js";
import { IRRADIANCE_EDGE } from "./probe-rays.js";

/** Turns the probes' radiance, in spherical harmonics, into the irradiance atlas. */
export class IrradianceConvolution {
  readonly #gpu: Gpu;
  readonly #screen: VertexArray;
  readonly #volume: UniformBlock;
  readonly #programs: readonly [plain: Program, extrapolated: Program];
  readonly #tailProgram: Program;
  readonly #tail: RenderTarget;
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
      gpu.program("gi/irradiance", fullscreenVert, irradianceFrag, { defines: { EXTRAPOLATED } });
    this.#programs = [program(0), program(1)];
    this.#tailProgram = gpu.program("gi/bounce-tail", fullscreenVert, bounceTailFrag);
    this.#tail = gpu.renderTarget({
      label: "gi/bounce-tail",
      width: 1,
      height: 1,
      color: ["RGBA16F"],
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

  render(radiance: RenderTarget): void {
    this.#draw(this.#programs[0], harmonicsOf(radiance));
  }

  /** The same after all bounces, from the radiance after the last three of them. */
  renderExtrapolated(before: RenderTarget, previous: RenderTarget, last: RenderTarget): void {
    this.#gpu.draw({
      program: this.#tailProgram,
      target: this.#tail,
      vertexArray: this.#screen,
      textures: { uLast: last.color, uPrevious: previous.color, uBefore: before.color },
    });
    const { uSh0, uSh1, uSh2 } = harmonicsOf(previous);
    this.#draw(this.#programs[1], {
      ...harmonicsOf(last),
      uPreviousSh0: uSh0,
      uPreviousSh1: uSh1,
      uPreviousSh2: uSh2,
      uTail: this.#tail.color,
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

/** The three textures of the spherical harmonics of radiance. */
export function harmonicsOf({ colors }: RenderTarget) {
  const [uSh0, uSh1, uSh2] = colors;
  if (!uSh0 || !uSh1 || !uSh2) throw new Error("Spherical harmonics take three textures.");
  return { uSh0, uSh1, uSh2 };
}
