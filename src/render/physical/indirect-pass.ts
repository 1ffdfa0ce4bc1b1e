import { mat4 } from "gl-matrix";
import fullscreenVert from "../../../shaders/physical/fullscreen.vert";
import probeFrag from "../../../shaders/physical/probe.frag";
import radiosityFrag from "../../../shaders/physical/radiosity.frag";
import surfelFrag from "../../../shaders/physical/surfel.frag";
import surfelVert from "../../../shaders/physical/surfel.vert";
import type { Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { RenderTarget } from "../../gl/render-target.js";
import type { Texture } from "../../gl/texture.js";
import type { UniformBlock } from "../../gl/uniform-block.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import type { Bounds, Vec3 } from "../../world/bounds.js";
import type { Casters } from "./casters.js";
import { clipFromFace, FACES } from "./cube.js";
import type { LightAtVantage } from "./light-block.js";

/** How finely indirect light is known. */
export interface IndirectDetail {
  /** Patches along an edge of the cube around the flame. */
  readonly patches: number;
  /** Probes along x, y, z. */
  readonly probes: readonly [number, number, number];
  /** Times that light is passed on. */
  readonly bounces: number;
}

/** Indirect light everywhere in the room, for shaders that include `physical/volume.glsl`. */
export interface IrradianceVolume {
  readonly block: UniformBlock;
  readonly textures: {
    readonly uVolumeRed: Texture;
    readonly uVolumeGreen: Texture;
    readonly uVolumeBlue: Texture;
  };
}

/**
 * Light that has bounced off the room, without any precomputation.
 *
 * The flame sees the room as a few hundred patches; probes gather their light, patches gather the
 * probes', and so on for a number of bounces. It starts from darkness each time, so the result depends
 * on where the flame is and on nothing that was drawn before. Light adds up, so a flame that flickers
 * changes only what the result is multiplied by.
 */
export class IndirectPass {
  readonly #gpu: Gpu;
  readonly #detail: IndirectDetail;
  readonly #surfelProgram: Program;
  readonly #radiosityProgram: Program;
  readonly #probeProgram: Program;
  readonly #screen: VertexArray;
  readonly #block: UniformBlock;
  readonly #surfels: RenderTarget;
  readonly #radiosity: RenderTarget;
  readonly #volumes: readonly [RenderTarget, RenderTarget];
  readonly #light: UniformBlock;
  /** What the volume was made from. */
  #lastLight = "";

  constructor(gpu: Gpu, screen: VertexArray, { min, max }: Bounds, detail: IndirectDetail) {
    this.#gpu = gpu;
    this.#screen = screen;
    this.#detail = detail;
    this.#surfelProgram = gpu.program("physical/surfel", surfelVert, surfelFrag);
    this.#radiosityProgram = gpu.program("physical/radiosity", fullscreenVert, radiosityFrag);
    this.#probeProgram = gpu.program("physical/probe", fullscreenVert, probeFrag);
    this.#light = gpu.uniformBlock(this.#radiosityProgram, "Light");
    const [columns, rows, planes] = detail.probes;
    this.#block = gpu.uniformBlock(this.#probeProgram, "Volume");
    this.#block.update({
      corner: min,
      extent: [max[0] - min[0], max[1] - min[1], max[2] - min[2]],
      columns,
      rows,
      planes,
    });
    const patches = { width: detail.patches * FACES.length, height: detail.patches };
    this.#surfels = gpu.renderTarget({
      label: "indirect/surfels",
      ...patches,
      color: ["RGBA16F", "RGBA16F"],
      depth: "buffer",
      filter: "nearest",
    });
    this.#radiosity = gpu.renderTarget({
      label: "indirect/radiosity",
      ...patches,
      color: ["RGBA16F"],
      filter: "nearest",
    });
    const volume = (name: string) =>
      gpu.renderTarget({
        label: `indirect/${name}`,
        width: columns * planes,
        height: rows,
        color: ["RGBA16F", "RGBA16F", "RGBA16F"],
      });
    this.#volumes = [volume("volume"), volume("volume before")];
  }

  /**
   * Light that the room throws back for each candela of the flame's.
   *
   * @param light members of the block of `physical/light.glsl`, of a flame at its vantage
   */
  render(casters: Casters, light: LightAtVantage): IrradianceVolume {
    const key = JSON.stringify(light);
    if (key !== this.#lastLight) {
      this.#lastLight = key;
      this.#light.update(light);
      this.#capture(casters, light.position);
      this.#gpu.clear(this.#volumes[0], [0, 0, 0, 0]);
      for (let bounce = 0; bounce < this.#detail.bounces; bounce++) this.#bounce(bounce);
    }
    return this.#result(this.#detail.bounces);
  }

  #result(bounces: number): IrradianceVolume {
    const { colors } = this.#volumes[bounces % 2 === 0 ? 0 : 1];
    const [red, green, blue] = colors;
    if (!red || !green || !blue) throw new Error("An irradiance volume has three channels.");
    return {
      block: this.#block,
      textures: { uVolumeRed: red, uVolumeGreen: green, uVolumeBlue: blue },
    };
  }

  #capture(casters: Casters, vantage: Vec3): void {
    const size = this.#detail.patches;
    this.#gpu.clear(this.#surfels, [0, 0, 0, 0]);
    for (const face of FACES.keys()) {
      const clipFromWorld = clipFromFace(face, vantage, mat4.create()) as Float32Array;
      casters.drawColored(face, vantage, {
        program: this.#surfelProgram,
        target: this.#surfels,
        viewport: [face * size, 0, size, size],
        uniforms: { uClipFromWorld: clipFromWorld, uLight: vantage },
        depth: "test-and-write",
        cull: "none",
      });
    }
  }

  #bounce(bounce: number): void {
    const [patchColor, normalDistance] = this.#surfels.colors;
    if (!patchColor || !normalDistance) throw new Error("A patch has a colour and a place.");
    const before = this.#result(bounce);
    this.#gpu.draw({
      program: this.#radiosityProgram,
      target: this.#radiosity,
      vertexArray: this.#screen,
      textures: {
        uPatchColor: patchColor,
        uNormalDistance: normalDistance,
        ...before.textures,
      },
      blocks: { Light: this.#light, Volume: this.#block },
    });
    this.#gpu.draw({
      program: this.#probeProgram,
      target: this.#volumes[bounce % 2 === 0 ? 1 : 0],
      vertexArray: this.#screen,
      textures: { uNormalDistance: normalDistance, uRadiosity: this.#radiosity.color },
      blocks: { Light: this.#light, Volume: this.#block },
    });
  }
}
