import rootFrag from "../../../shaders/deferred/root.frag";
import fullscreenVert from "../../../shaders/physical/fullscreen.vert";
import type { Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { Texture } from "../../gl/texture.js";
import type { VertexArray } from "../../gl/vertex-array.js";

/** Texels along the longer edge: what is seen on the way has no more. */
const MOST = 256;

/** Base colours that are cheap to read, made one by one and kept. */
export class RootTextures {
  readonly #gpu: Gpu;
  readonly #screen: VertexArray;
  readonly #roots = new Map<Texture, Texture>();
  #program: Program | null = null;

  constructor(gpu: Gpu, screen: VertexArray) {
    this.#gpu = gpu;
    this.#screen = screen;
  }

  /** The root of a base colour; null before it is made. */
  of(albedo: Texture): Texture | null {
    return this.#roots.get(albedo) ?? null;
  }

  /** Makes the next that is missing: one for each picture drawn. */
  proceed(albedos: Iterable<Texture>): void {
    for (const albedo of albedos) {
      if (this.#roots.has(albedo)) continue;
      this.#roots.set(albedo, this.#make(albedo));
      return;
    }
  }

  #make(albedo: Texture): Texture {
    const share = Math.min(1, MOST / Math.max(albedo.width, albedo.height));
    const texels = (length: number) => Math.max(1, Math.round(length * share));
    const root = this.#gpu.texture({
      label: `${albedo.label}/root`,
      format: "RGBA8",
      source: { width: texels(albedo.width), height: texels(albedo.height) },
      mipmaps: true,
      wrap: "repeat",
    });
    const target = this.#gpu.textureView({ label: root.label, textures: [root], image: 0 });
    this.#program ??= this.#gpu.program("deferred/root", fullscreenVert, rootFrag);
    this.#gpu.draw({
      program: this.#program,
      target,
      vertexArray: this.#screen,
      textures: { uAlbedo: albedo },
    });
    target.dispose();
    root.updateMipmaps();
    root.reading = "level";
    return root;
  }
}
