import gamma2Frag from "../../../shaders/gbuffer/gamma2-albedo.frag";
import type { Gpu, Texture } from "../../gl/gpu.js";
import type { Mesh } from "../mesh/mesh.js";

/** Texels along the longer edge: in motion more are seen from nearby alone. */
const LONGEST_EDGE = 256;

/** Whether roughness and occlusion are baked into the albedo: for what is neither metal nor cut out. */
export function isBaked({ uniforms }: Mesh): boolean {
  const [, metallic, , alphaCutoff] = uniforms.uSurface;
  return metallic === 0 && alphaCutoff === 0;
}

/** Whether two meshes have the same gamma-2 albedo. */
function isSame(one: Mesh, other: Mesh): boolean {
  if (one.textures.uAlbedo !== other.textures.uAlbedo || isBaked(one) !== isBaked(other))
    return false;
  return (
    !isBaked(one) ||
    (one.textures.uOcclusionRoughness === other.textures.uOcclusionRoughness &&
      one.uniforms.uOcclusionStrength === other.uniforms.uOcclusionStrength)
  );
}

/** Gamma-2 albedo textures for the reduced G-buffer, made one a frame. */
export class AlbedoCache {
  readonly #gpu: Gpu;
  /** By the textures of a mesh, which its lower level of detail has, too. */
  readonly #made = new Map<Mesh["textures"], { readonly mesh: Mesh; readonly albedo: Texture }>();
  /** Whether none was missing at the last update. */
  isComplete = false;

  constructor(gpu: Gpu) {
    this.#gpu = gpu;
  }

  /** Null before it is made. */
  of({ textures }: Mesh): Texture | null {
    return this.#made.get(textures)?.albedo ?? null;
  }

  /** Makes the next one that is missing. */
  updateIncrementally(meshes: Iterable<Mesh>): void {
    for (const mesh of meshes) {
      if (this.of(mesh)) continue;
      const known = [...this.#made.values()].find((made) => isSame(made.mesh, mesh));
      this.#made.set(mesh.textures, { mesh, albedo: known?.albedo ?? this.#make(mesh) });
      if (!known) return;
    }
    this.isComplete = true;
  }

  #make(mesh: Mesh): Texture {
    const { uAlbedo, uOcclusionRoughness } = mesh.textures;
    const BAKED = isBaked(mesh) ? 1 : 0;
    const source = BAKED && uAlbedo.width === 1 ? uOcclusionRoughness : uAlbedo;
    const scale = Math.min(1, LONGEST_EDGE / Math.max(source.width, source.height));
    const texels = (length: number) => Math.max(1, Math.round(length * scale));
    const texture = this.#gpu.texture({
      label: `${uAlbedo.label}/gamma 2`,
      format: "RGBA8",
      source: { width: texels(source.width), height: texels(source.height) },
      mipmaps: true,
      wrap: "repeat",
    });
    const target = this.#gpu.textureView({ label: texture.label, textures: [texture] });
    this.#gpu.draw({
      program: this.#gpu.pass("gbuffer/gamma2-albedo", gamma2Frag, {
        defines: { BAKED },
      }),
      target,
      textures: mesh.textures,
      uniforms: { uOcclusionStrength: mesh.uniforms.uOcclusionStrength },
    });
    target.dispose();
    texture.updateMipmaps();
    return texture;
  }
}
