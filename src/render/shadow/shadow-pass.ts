import { mat4 } from "gl-matrix";
import cubeFaceVert from "../../../shaders/shadow/cube-face.vert";
import shadowFrag from "../../../shaders/shadow/shadow.frag";
import type { Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { Texture, TextureFormat } from "../../gl/texture.js";
import type { TextureView } from "../../gl/texture-view.js";
import type { Bounds, Vec3 } from "../../world/geometry.js";
import { SCHEDULE } from "../schedule.js";
import { clipFromFace, FACES } from "./cube-map.js";
import type { ShadowCasters } from "./shadow-casters.js";

/** Distance where there is no caster, metres. */
const FAR_DISTANCE = [1e4, 0, 0, 1] as const;

/** A shadow cube and the point that it was captured from. */
export interface ShadowCube {
  /** Metres. */
  readonly distances: Texture;
  readonly captureOrigin: Vec3;
  /** Whether it was drawn in this frame. */
  readonly isNew: boolean;
}

/** Shadow cube map: distance of the nearest caster in every direction from the capture origin. */
export class ShadowPass {
  readonly #gpu: Gpu;
  readonly #program: Program;
  readonly #distances: Texture;
  readonly #faces: readonly TextureView[];
  #lastOrigin: Vec3 = [Number.NaN, 0, 0];
  /** Casters in the cube; null if some of them were culled. */
  #allCasters: ShadowCasters | null = null;
  /** Frames since the cube was drawn. */
  #age = 0;

  /** @param size texels along an edge of the cube */
  constructor(gpu: Gpu, size: number, format: TextureFormat) {
    this.#gpu = gpu;
    this.#program = gpu.program("shadow/shadow", cubeFaceVert, shadowFrag);
    const source = { width: size, height: size };
    this.#distances = gpu.texture({
      label: "shadow/distances",
      format,
      source,
      shape: "cube",
      // Distances must not be filtered: the mean of a caster and its background is neither.
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

  /** Distances from the capture origin; drawn only if origin or casters have changed. */
  render(casters: ShadowCasters, captureOrigin: Vec3): Texture {
    if (this.#distanceMoved(captureOrigin) > 0 || this.#allCasters !== casters) {
      this.#draw(casters, captureOrigin);
    }
    return this.#distances;
  }

  /**
   * Amortised update for a moving light: in most frames, the cube of an earlier one.
   *
   * @param isBusy whether this frame takes long anyway
   * @param isNeeded whether the contents of a box cast shadows into view, while the light moves
   */
  updateIncrementally(
    casters: ShadowCasters,
    captureOrigin: Vec3,
    { isBusy, isNeeded }: { readonly isBusy: boolean; readonly isNeeded: (box: Bounds) => boolean },
  ): ShadowCube {
    const moved = this.#distanceMoved(captureOrigin);
    this.#age++;
    const { frames, busyFrames, distance } = SCHEDULE.shadow;
    const isDue = this.#age >= (isBusy ? busyFrames : frames) || moved > distance;
    // A cube for a light at rest serves many frames: no caster is culled.
    const isAtRest = moved === 0;
    const isNew = isAtRest ? !this.#allCasters : isDue;
    if (isNew) this.#draw(casters, captureOrigin, isAtRest ? undefined : isNeeded);
    return { distances: this.#distances, captureOrigin: this.#lastOrigin, isNew };
  }

  /** Metres since the last capture; infinite before the first. */
  #distanceMoved(captureOrigin: Vec3): number {
    const distance = Math.hypot(
      ...captureOrigin.map((x, axis) => x - (this.#lastOrigin[axis] ?? 0)),
    );
    return Number.isNaN(distance) ? Number.POSITIVE_INFINITY : distance;
  }

  #draw(casters: ShadowCasters, captureOrigin: Vec3, isNeeded?: (box: Bounds) => boolean): void {
    this.#allCasters = isNeeded ? null : casters;
    this.#age = 0;
    this.#lastOrigin = [...captureOrigin];
    for (const [face, target] of this.#faces.entries()) {
      const clipFromWorld = clipFromFace(face, captureOrigin, mat4.create()) as Float32Array;
      this.#gpu.clear(target, FAR_DISTANCE);
      const pass = {
        program: this.#program,
        target,
        uniforms: { uClipFromWorld: clipFromWorld, uCaptureOrigin: captureOrigin },
        depth: "test-and-write",
        cull: "none",
      } as const;
      casters.draw(face, captureOrigin, pass, isNeeded);
    }
  }
}
