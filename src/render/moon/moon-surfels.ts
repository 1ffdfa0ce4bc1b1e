import radiosityFrag from "../../../shaders/gi/radiosity.frag";
import surfelFrag from "../../../shaders/gi/surfel.frag";
import fullscreenVert from "../../../shaders/post/fullscreen.vert";
import cubeFaceVert from "../../../shaders/shadow/cube-face.vert";
import type { Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { RenderTarget } from "../../gl/render-target.js";
import type { Texture } from "../../gl/texture.js";
import type { UniformBlock } from "../../gl/uniform-block.js";
import { floats } from "../float-format.js";
import type { Surfels } from "../gi/surfel-pass.js";
import type { CaptureLight } from "../light-block.js";
import { FACES } from "../shadow/cube-map.js";
import type { ShadowCasters } from "../shadow/shadow-casters.js";
import { clipFromFrustum, type MoonFrustum } from "./moon-frustum.js";
import type { SurfelVisibility } from "./surfel-visibility.js";

/** Surfels that the moon lights, on its map; in the last rows the panes that the sky shines through. */
export class MoonSurfels implements Surfels {
  readonly light: { readonly Moon: UniformBlock };
  readonly defines = { MOON: 1 };
  readonly #gpu: Gpu;
  readonly #captureProgram: Program;
  readonly #radiosityProgram: Program;
  readonly #surfels: RenderTarget;
  readonly #radiosity: RenderTarget;
  readonly #rows: number;
  #frustum: MoonFrustum | null = null;
  #visibility: Texture | null = null;

  /**
   * @param size rows of surfels; there are as many columns as six times that
   * @param group rows of those on the panes
   */
  constructor(gpu: Gpu, size: number, group: number) {
    this.#gpu = gpu;
    this.#rows = size - group;
    this.#captureProgram = gpu.program("gi/surfel", cubeFaceVert, surfelFrag, {
      defines: { PARALLEL: 1 },
    });
    this.#radiosityProgram = gpu.program("gi/radiosity", fullscreenVert, radiosityFrag, {
      defines: this.defines,
    });
    this.light = { Moon: gpu.uniformBlock(this.#radiosityProgram, "Moon") };
    const texel = floats(gpu, 4);
    const map = { width: size * FACES.length, height: size, filter: "nearest" } as const;
    this.#surfels = gpu.renderTarget({
      label: "moon/surfels",
      ...map,
      color: [texel, texel],
      depth: "buffer",
    });
    this.#radiosity = gpu.renderTarget({ label: "moon/radiosity", ...map, color: ["RGBA16F"] });
  }

  /** To be called before each capture. */
  prepare(frustum: MoonFrustum, { data, ...size }: SurfelVisibility): void {
    this.#frustum = frustum;
    this.#visibility?.dispose();
    this.#visibility = this.#gpu.texture({
      label: "moon/surfel-visibility",
      format: "R8",
      source: { ...size, data },
      filter: "nearest",
    });
  }

  get visibility(): Surfels["visibility"] {
    return this.#visibility ? { uSurfelVisibility: this.#visibility } : {};
  }

  /** Surfels on the map. */
  get detail(): Readonly<Record<"columns" | "rows" | "paneRows", number>> {
    const { width: columns, height } = this.#radiosity;
    return { columns, rows: this.#rows, paneRows: height - this.#rows };
  }

  get normalDistance(): Texture {
    return this.#colors.uSurfelNormalDistance;
  }

  get radiosity(): Texture {
    return this.#radiosity.color;
  }

  /** Not used for the moon. */
  get totalRadiosity(): Texture {
    return this.#radiosity.color;
  }

  get support(): Texture {
    return this.#radiosity.color;
  }

  /** Captures all surfels at the first of a flame's six faces. */
  capture(casters: ShadowCasters, _: unknown, face: number): void {
    const frustum = this.#frustum;
    if (face > 0 || !frustum) return;
    this.#gpu.clear(this.#surfels, [0, 0, 0, 0]);
    const pass = {
      program: this.#captureProgram,
      target: this.#surfels,
      viewport: [0, 0, this.#surfels.width, this.#rows],
      uniforms: {
        uClipFromWorld: clipFromFrustum(frustum),
        uCaptureOrigin: frustum.corner,
        uDirection: frustum.direction,
      },
      depth: "test-and-write",
      cull: "none",
    } as const;
    casters.drawWithAlbedo(pass, () => true);
  }

  renderRadiosity(light: CaptureLight): void {
    this.light.Moon.update(light);
    this.#gpu.draw({
      program: this.#radiosityProgram,
      target: this.#radiosity,
      textures: this.#colors,
      blocks: this.light,
    });
  }

  renderTotalRadiosity(): void {}

  get #colors() {
    const [uSurfelReflectance, uSurfelNormalDistance] = this.#surfels.colors;
    if (!uSurfelReflectance || !uSurfelNormalDistance) {
      throw new Error("Surfels take two textures: reflectance, and normal with distance.");
    }
    return { uSurfelReflectance, uSurfelNormalDistance };
  }
}
