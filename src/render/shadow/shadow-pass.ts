import { mat4 } from "gl-matrix";
import shadowFrag from "../../../shaders/shadow/shadow.frag";
import shadowVert from "../../../shaders/shadow/shadow.vert";
import type { Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { Texture, TextureFormat } from "../../gl/texture.js";
import type { TextureView } from "../../gl/texture-view.js";
import type { Bounds, Vec3 } from "../../world/geometry.js";
import { SCHEDULE } from "../schedule.js";
import { clipFromFace, FACES } from "./cube-map.js";
import type { ShadowCasters } from "./shadow-casters.js";

/** Farther than anything. */
const NOTHING = [1e4, 0, 0, 1] as const;

/** Distances, metres, in a cube around a vantage. */
export interface ShadowCube {
  readonly distances: Texture;
  readonly vantage: Vec3;
  /** Whether it was drawn for this picture. */
  readonly isNew: boolean;
}

/** What the flame sees of the room: the distance of the nearest thing in every direction. */
export class ShadowPass {
  readonly #gpu: Gpu;
  readonly #program: Program;
  readonly #distances: Texture;
  readonly #faces: readonly TextureView[];
  #lastVantage: Vec3 = [Number.NaN, 0, 0];
  /** Of which nothing was left out; null where something was. */
  #whole: ShadowCasters | null = null;
  /** Pictures since it was drawn. */
  #age = 0;

  /** @param size texels along an edge of the cube */
  constructor(gpu: Gpu, size: number, format: TextureFormat = "R16F") {
    this.#gpu = gpu;
    this.#program = gpu.program("shadow/shadow", shadowVert, shadowFrag);
    const source = { width: size, height: size };
    this.#distances = gpu.texture({
      label: "shadow/distances",
      format,
      source,
      shape: "cube",
      // A mean of what casts a shadow and what lies behind it is the distance of nothing.
      filter: "nearest",
    });
    const depth = gpu.texture({
      label: "shadow/depth",
      format: "DEPTH_COMPONENT24",
      source,
      filter: "nearest",
    });
    this.#faces = FACES.map((_, image) =>
      gpu.textureView({ label: `shadow/${image}`, textures: [this.#distances], image, depth }),
    );
  }

  /** Distances from the vantage, drawn anew where it is another than before. */
  render(casters: ShadowCasters, vantage: Vec3): Texture {
    if (this.#hasMovedBy(vantage) > 0 || this.#whole !== casters) this.#draw(casters, vantage);
    return this.#distances;
  }

  /**
   * The same for one picture among many, perhaps from where the light was in the one before.
   *
   * @param isBusy whether this picture takes long anyway
   * @param matters whether what is in a box is needed of a picture that the next will not be like
   */
  follow(
    casters: ShadowCasters,
    vantage: Vec3,
    { isBusy, matters }: { readonly isBusy: boolean; readonly matters: (box: Bounds) => boolean },
  ): ShadowCube {
    const way = this.#hasMovedBy(vantage);
    this.#age++;
    const isDue =
      this.#age >= (isBusy ? SCHEDULE.shadow.busyFrames : SCHEDULE.shadow.frames) ||
      way > SCHEDULE.shadow.distance;
    // Who stands still is worth the whole.
    const isWhole = way === 0;
    const isNew = isWhole ? !this.#whole : isDue;
    if (isNew) this.#draw(casters, vantage, isWhole ? undefined : matters);
    return { distances: this.#distances, vantage: this.#lastVantage, isNew };
  }

  /** Metres; infinitely far where there was nothing before. */
  #hasMovedBy(vantage: Vec3): number {
    const way = Math.hypot(...vantage.map((x, axis) => x - (this.#lastVantage[axis] ?? 0)));
    return Number.isNaN(way) ? Number.POSITIVE_INFINITY : way;
  }

  #draw(casters: ShadowCasters, vantage: Vec3, matters?: (box: Bounds) => boolean): void {
    this.#whole = matters ? null : casters;
    this.#age = 0;
    this.#lastVantage = [...vantage];
    for (const [face, target] of this.#faces.entries()) {
      const clipFromWorld = clipFromFace(face, vantage, mat4.create()) as Float32Array;
      this.#gpu.clear(target, NOTHING);
      const how = {
        program: this.#program,
        target,
        uniforms: { uClipFromWorld: clipFromWorld, uLight: vantage },
        depth: "test-and-write",
        cull: "none",
      } as const;
      casters.draw(face, vantage, how, matters);
    }
  }
}
