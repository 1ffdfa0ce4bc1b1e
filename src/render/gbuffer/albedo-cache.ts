import rootFrag from "../../../shaders/gbuffer/gamma2-albedo.frag";
import fullscreenVert from "../../../shaders/post/fullscreen.vert";
import type { Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { Texture } from "../../gl/texture.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import type { Surface } from "../mesh/mesh.js";

/** Texels along the longer edge: what is seen on the way has no more. */
const MOST = 256;

/** Whether roughness lies beside the colour and crevices are painted on: where nothing is metal or cut out. */
export function isBaked({ parameters: [, metallic, , nothingBelow] }: Surface): boolean {
  return metallic === 0 && nothingBelow === 0;
}

/** Base colours that are cheap to read, made one by one and kept. */
export class AlbedoCache {
  readonly #gpu: Gpu;
  readonly #screen: VertexArray;
  /** By base colour, and by what is baked into it. */
  readonly #roots = new Map<Texture, Map<Texture | null, Texture>>();
  readonly #programs: Record<string, Program> = {};
  /** Whether none was missing when this was last gone on with. */
  isComplete = false;

  constructor(gpu: Gpu, screen: VertexArray) {
    this.#gpu = gpu;
    this.#screen = screen;
  }

  /** The root of a base colour; null before it is made. */
  of(surface: Surface): Texture | null {
    const { uAlbedo, uOcclusionRoughness } = surface.textures;
    const roots = this.#roots.get(uAlbedo);
    return roots?.get(isBaked(surface) ? uOcclusionRoughness : null) ?? null;
  }

  /** Makes the next that is missing: one for each picture drawn. */
  proceed(surfaces: Iterable<Surface>): void {
    for (const surface of surfaces) {
      if (this.of(surface)) continue;
      const { uAlbedo, uOcclusionRoughness } = surface.textures;
      const roots = this.#roots.get(uAlbedo) ?? new Map<Texture | null, Texture>();
      this.#roots.set(uAlbedo, roots);
      roots.set(isBaked(surface) ? uOcclusionRoughness : null, this.#make(surface));
      return;
    }
    this.isComplete = true;
  }

  #make(surface: Surface): Texture {
    const { uAlbedo, uOcclusionRoughness } = surface.textures;
    const BAKED = isBaked(surface) ? 1 : 0;
    const most = BAKED && uAlbedo.width === 1 ? uOcclusionRoughness : uAlbedo;
    const share = Math.min(1, MOST / Math.max(most.width, most.height));
    const texels = (length: number) => Math.max(1, Math.round(length * share));
    const root = this.#gpu.texture({
      label: `${uAlbedo.label}/root`,
      format: "RGBA8",
      source: { width: texels(most.width), height: texels(most.height) },
      mipmaps: true,
      wrap: "repeat",
    });
    const target = this.#gpu.textureView({ label: root.label, textures: [root], image: 0 });
    this.#programs[BAKED] ??= this.#gpu.program("gbuffer/gamma2-albedo", fullscreenVert, rootFrag, {
      defines: { BAKED },
    });
    this.#gpu.draw({
      program: this.#programs[BAKED],
      target,
      vertexArray: this.#screen,
      textures: BAKED ? { uAlbedo, uOcclusionRoughness } : { uAlbedo },
      ...(BAKED && { uniforms: { uOcclusionStrength: surface.occlusionStrength } }),
    });
    target.dispose();
    root.updateMipmaps();
    return root;
  }
}
