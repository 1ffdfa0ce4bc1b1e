import showFrag from "../../../shaders/deferred/show.frag";
import tableFrag from "../../../shaders/deferred/table.frag";
import displayVert from "../../../shaders/physical/display.vert";
import fullscreenVert from "../../../shaders/physical/fullscreen.vert";
import type { Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { Texture } from "../../gl/texture.js";
import type { UniformBlock } from "../../gl/uniform-block.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import type { DisplayLaw } from "./display-pass.js";

/** Colours along an edge of the table: `TABLE_SIZE` of the shader. */
const SIZE = 32;

/** Puts light on paint and the result on the canvas, through a table of the display's law. */
export class ShowPass {
  readonly #gpu: Gpu;
  readonly #screen: VertexArray;
  readonly #show: Program;
  readonly #tabulate: Program;
  readonly #table: Texture;
  /** The law that the table is of. */
  #known = "";

  constructor(gpu: Gpu, screen: VertexArray) {
    this.#gpu = gpu;
    this.#screen = screen;
    this.#show = gpu.program("deferred/show", displayVert, showFrag);
    this.#tabulate = gpu.program("deferred/table", fullscreenVert, tableFrag);
    this.#table = gpu.texture({
      label: "display's table",
      format: "RGBA8",
      source: { width: SIZE, height: SIZE },
      shape: { layers: SIZE },
    });
  }

  render(
    textures: Readonly<Record<"uPainted" | "uLight" | "uBloom" | "uExposure", Texture>>,
    { scattered, metered }: { readonly scattered: number; readonly metered: boolean },
    law: DisplayLaw,
    blocks: Readonly<Record<string, UniformBlock>>,
  ): void {
    this.#update(law);
    this.#gpu.draw({
      program: this.#show,
      target: "canvas",
      vertexArray: this.#screen,
      textures: { ...textures, uTable: this.#table },
      uniforms: {
        uBalance: law.uAdaptation.map((gain, i) => gain / (law.uWhite[i] ?? 1)),
        uScattered: scattered,
        uMetered: metered ? 1 : 0,
      },
      blocks,
    });
  }

  #update({ uAdaptation: _, ...law }: DisplayLaw): void {
    const known = JSON.stringify(law);
    if (known === this.#known) return;
    this.#known = known;
    for (let layer = 0; layer < SIZE; layer++) {
      const target = this.#gpu.textureView({
        label: `display's table/${layer}`,
        textures: [this.#table],
        image: layer,
      });
      this.#gpu.draw({
        program: this.#tabulate,
        target,
        vertexArray: this.#screen,
        uniforms: { ...law, uLayer: layer },
      });
      target.dispose();
    }
  }
}
