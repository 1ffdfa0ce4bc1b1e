import type { Gpu, Texture } from "../../gl/gpu.js";
import { Surfels } from "../gi/surfels.js";
import { FACES } from "../shadow/cube-map.js";
import type { ShadowCasters } from "../shadow/shadow-casters.js";
import { clipFromFrustum, type MoonFrustum } from "./moon-frustum.js";
import type { SurfelVisibility } from "./surfel-visibility.js";

/** Surfels that the moon lights, on its map; in the last rows the panes that the sky shines through. */
export class MoonSurfels extends Surfels {
  readonly #rows: number;
  #frustum: MoonFrustum | null = null;
  #visibility: Texture | null = null;

  /** @param group rows of those on the panes */
  constructor(gpu: Gpu, size: number, group: number) {
    super(gpu, size, "Moon");
    this.#rows = size - group;
  }

  /** To be called before each capture. */
  prepare(frustum: MoonFrustum, { data, ...size }: SurfelVisibility): void {
    this.#frustum = frustum;
    this.#visibility?.dispose();
    this.#visibility = this.gpu.texture({
      label: "moon/surfel-visibility",
      format: "R8",
      source: { ...size, data },
      filter: "nearest",
    });
  }

  override get visibility(): { readonly uSurfelVisibility?: Texture } {
    return this.#visibility ? { uSurfelVisibility: this.#visibility } : {};
  }

  /** Surfels on the map. */
  get detail(): Readonly<Record<"columns" | "rows" | "paneRows", number>> {
    const rows = this.#rows;
    return { columns: this.size * FACES.length, rows, paneRows: this.size - rows };
  }

  /** Captures all surfels at the first of a flame's six faces. */
  capture(casters: ShadowCasters, _: unknown, face: number): void {
    const frustum = this.#frustum;
    if (face > 0 || !frustum) return;
    const uniforms = {
      uClipFromWorld: clipFromFrustum(frustum),
      uCaptureOrigin: frustum.corner,
      uDirection: frustum.direction,
    };
    const viewport = [0, 0, this.size * FACES.length, this.#rows] as const;
    this.draw(casters, { viewport, uniforms }, () => true);
  }
}
