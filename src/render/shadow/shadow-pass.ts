import { vec3 } from "gl-matrix";
import type { Gpu, Texture } from "../../gl/gpu.js";
import type { Bounds, Vec3 } from "../../world/geometry.js";
import { finish, type Steps } from "../../world/steps.js";
import { frustumTest } from "../camera.js";
import { SCHEDULE } from "../schedule.js";
import { clipFromShadowFace, FACES, NEAR } from "./cube-map.js";
import type { Casters } from "./shadow-casters.js";

/** Width of a face's tile as a share of the face's: `SHADOW_REACH` of `shaders/lib/shadow-tiles.glsl`. */
const REACH = 1.125;

export type ShadowAtlas = Readonly<ReturnType<typeof shadowAtlas>>;

/**
 * A texture of one shadow cube or several, one above another.
 *
 * @param size texels along an edge of a cube, at most
 * @param near what is nearer to a light casts no shadow, metres
 */
export function shadowAtlas(gpu: Gpu, size: number, slots: number, near = NEAR) {
  let tile = size * REACH;
  while (2 * tile * slots > gpu.longestSide) tile /= 2;
  const depth = gpu.texture({
    label: "shadow/depth",
    format: "DEPTH_COMPONENT16",
    source: { width: 3 * tile, height: 2 * tile * slots },
    // Depths must not be filtered: the mean of a caster and its background is neither.
    filter: "nearest",
  });
  const target = gpu.textureView({ label: "shadow", textures: [], depth });
  return {
    depth,
    target,
    /** Texels along a tile's edge. */
    tile,
    near,
  };
}

/** A shadow cube and the point that it was captured from. */
export interface ShadowCube {
  /** Depth of the faces, in tiles. */
  readonly depth: Texture;
  readonly captureOrigin: Vec3;
  /** Whether it was drawn in this frame. */
  readonly isNew: boolean;
}

/**
 * Shadow cube: depth of the nearest caster in every direction from the capture origin.
 *
 * Its faces are tiles of one depth texture, a column for each axis and a row for each sign, so that a tap needs no
 * choice of a face: `shaders/lib/shadow-tiles.glsl`.
 */
export class ShadowPass {
  readonly #gpu: Gpu;
  readonly #atlas: ShadowAtlas;
  readonly #slot: number;
  #lastOrigin: Vec3 = [Number.NaN, 0, 0];
  /** Casters in the cube; null if some of them were culled. */
  #allCasters: Casters | null = null;
  #age = 0;

  /** @param slot in the texture, which other lights may share */
  constructor(gpu: Gpu, atlas: ShadowAtlas, slot = 0) {
    this.#gpu = gpu;
    this.#atlas = atlas;
    this.#slot = slot;
  }

  /** Depth of the faces; drawn only if origin or casters have changed, a face in each step. */
  *update(casters: Casters, captureOrigin: Vec3): Steps<Texture> {
    if (this.#distanceMoved(captureOrigin) > 0 || this.#allCasters !== casters) {
      yield* this.steps(casters, captureOrigin);
    }
    return this.#atlas.depth;
  }

  /**
   * Amortised update for a moving light: in most frames, the cube of an earlier one.
   *
   * @param isBusy whether this frame takes long anyway
   * @param isNeeded whether the contents of a box cast shadows into view, while the light moves
   */
  updateIncrementally(
    casters: Casters,
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
    if (isNew) finish(this.steps(casters, captureOrigin, isAtRest ? undefined : isNeeded));
    return { depth: this.#atlas.depth, captureOrigin: this.#lastOrigin, isNew };
  }

  /** Metres since the last capture; infinite before the first. */
  #distanceMoved(captureOrigin: Vec3): number {
    const distance = vec3.distance(captureOrigin, this.#lastOrigin);
    return Number.isNaN(distance) ? Infinity : distance;
  }

  /**
   * Draws the cube, a face at each step.
   *
   * @param isNeeded whether the contents of a box are drawn. Default: all are
   */
  *steps(
    casters: Casters,
    captureOrigin: Vec3,
    isNeeded?: (box: Bounds) => boolean,
  ): Steps<Texture> {
    this.#allCasters = null;
    this.#age = 0;
    this.#lastOrigin = [Number.NaN, 0, 0];
    const { target, tile, near, depth } = this.#atlas;
    this.#gpu.clear(target, [0, 0, 0, 0], [0, 2 * tile * this.#slot, 3 * tile, 2 * tile]);
    for (const face of FACES.keys()) {
      const uClipFromWorld = clipFromShadowFace(face, captureOrigin, REACH, near);
      const isInFace = frustumTest(uClipFromWorld);
      const [x, y] = [(face >> 1) * tile, ((face % 2) + 2 * this.#slot) * tile];
      casters.drawDepth(
        { target, viewport: [x, y, tile, tile], uClipFromWorld },
        (box) => isInFace(box) && (isNeeded?.(box) ?? true),
      );
      yield;
    }
    this.#allCasters = isNeeded ? null : casters;
    this.#lastOrigin = [...captureOrigin];
    return depth;
  }
}
