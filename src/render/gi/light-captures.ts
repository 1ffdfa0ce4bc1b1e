import { vec3 } from "gl-matrix";
import type { Gpu } from "../../gl/gpu.js";
import { finish, type Steps } from "../../world/steps.js";
import type { World } from "../../world/world.js";
import { type CachedLight, isMoonAlone } from "../cached-light.js";
import { CachedLights } from "../cached-lights.js";
import { shadowFrustumTest } from "../camera.js";
import type { FrameInput } from "../frame-input.js";
import type { GBufferKind } from "../gbuffer/gbuffer.js";
import type { CaptureLight } from "../light-block.js";
import { hasLods } from "../mesh/mesh-lods.js";
import { MOTION_ERROR, type PhysicalTier } from "../quality.js";
import { clustersOf, ShadowCasters } from "../shadow/shadow-casters.js";
import { type ShadowCube, ShadowPass, shadowAtlas } from "../shadow/shadow-pass.js";
import { fitToRoom } from "./fit-to-room.js";
import { IndirectPass, type IndirectScene } from "./indirect-pass.js";
import { indirectTargets } from "./indirect-targets.js";
import { IndirectUpdates } from "./indirect-updates.js";
import type { IrradianceVolume } from "./irradiance-volume.js";

/** Margin of the view frustum in culling of casters, for the flame's penumbra, metres. */
const PENUMBRA = 0.05;

/** Sway of the flame that captures may be held for, metres. */
const SWAY = 0.006;

export interface FlameCaptures {
  readonly shadow: ShadowCube;
  readonly irradiance: IrradianceVolume;
}

export interface Captures extends FlameCaptures {
  /** The lights beside the carried flame. */
  readonly cached: readonly CachedLight[];
}

/**
 * Shadow cube and irradiance volume of the flame.
 *
 * At rest indirect light becomes exact within a few frames; in motion it is updated incrementally, and at `low` so is the
 * shadow cube, from simplified casters.
 */
export class LightCaptures {
  readonly #gpu: Gpu;
  readonly #room: IndirectScene;
  readonly #hasLods: boolean;
  readonly #casters: ShadowCasters;
  /** Simplified, for motion; null until their meshes are ready. */
  #shadowLod: ShadowCasters | null = null;
  #surfelLod: ShadowCasters | null = null;
  readonly #shadow: ShadowPass;
  readonly #indirect: IndirectPass;
  readonly #updates: IndirectUpdates;
  #holding: Steps | null = null;
  /** What it captures. */
  #capturing: CaptureLight | null = null;
  /** Programs used when `hold` was last called. */
  #programsUsed = 0;
  #held: { readonly light: CaptureLight; readonly captures: FlameCaptures } | null = null;
  readonly #cachedLights: CachedLights;
  /** Whether the moon's light alone has shadows of its first bounce. */
  readonly #hasNight: boolean;

  /** @param isSimplified whether casters are simplified in motion, where the model allows */
  constructor(gpu: Gpu, room: IndirectScene, tier: PhysicalTier, isSimplified: boolean) {
    const { shadow, casterError } = tier;
    const indirect = fitToRoom(tier.indirect, room.collision, room.model);
    this.#gpu = gpu;
    this.#room = room;
    this.#hasNight = tier.opaque !== "deferred";
    this.#hasLods = isSimplified && hasLods(room.surfaces);
    this.#casters = new ShadowCasters(gpu, room.model, room.surfaces, { error: casterError });
    this.#shadow = new ShadowPass(gpu, shadowAtlas(gpu, shadow.size, 1));
    const targets = indirectTargets(gpu, indirect);
    this.#indirect = new IndirectPass(gpu, room, indirect, targets);
    this.#updates = new IndirectUpdates(this.#indirect);
    // Where the flame's bounces are computed in steps, other lights' may come in between.
    const shared = tier.opaque === "refined" ? null : targets;
    this.#cachedLights = new CachedLights(gpu, room, { ...tier, indirect }, shared);
  }

  update(frame: FrameInput, kind: GBufferKind): Captures {
    const cached = finish(this.#lights(frame.world, frame.settings.canDefer));
    return { ...this.#ofFlame(frame, kind), cached };
  }

  /** Exact captures for a frame, in steps; `update` has nothing left to do then. */
  *steps({ world, captureLight }: FrameInput): Steps<Captures> {
    const cached = yield* this.#lights(world);
    return { ...(yield* this.#ofLight(captureLight)), cached };
  }

  /** @param isGradual whether what a new moon, or its light alone, needs may follow, a step in each call */
  *#lights(world: World, isGradual = false): Steps<readonly CachedLight[]> {
    const lights = yield* this.#cachedLights.steps(world, this.#casters, isGradual);
    if (!this.#hasNight || !isMoonAlone(world, lights)) return lights;
    const night = this.#cachedLights.night(this.#casters);
    if (isGradual) night.next();
    else yield* night;
    return yield* this.#cachedLights.steps(world, this.#casters, isGradual);
  }

  #ofFlame(
    { captureLight, clipFromWorld, settings }: FrameInput,
    kind: GBufferKind,
  ): FlameCaptures {
    if (this.#held) return this.#held.captures;
    if (kind === "full") {
      const captureOrigin = captureLight.position;
      const depth = finish(this.#shadow.update(this.#casters, captureOrigin));
      if (settings.canDefer) this.#prepareLods();
      const shadow = { depth, captureOrigin, isNew: false };
      const update = [this.#casters, captureLight, shadow] as const;
      const irradiance = settings.canDefer
        ? this.#updates.update(...update, { isExact: !settings.isMoving })
        : finish(this.#indirect.capture(...update));
      return { shadow, irradiance };
    }
    this.#prepareLods();
    const shadow = this.#shadow.updateIncrementally(
      this.#shadowLod ?? this.#casters,
      captureLight.position,
      {
        isBusy: kind === "reduced",
        isNeeded: shadowFrustumTest(clipFromWorld, captureLight.position, PENUMBRA),
      },
    );
    const irradiance = this.#updates.update(
      this.#surfelLod ?? this.#casters,
      captureLight,
      shadow,
      { isBusy: kind === "reduced" || shadow.isNew },
    );
    return { shadow, irradiance };
  }

  /**
   * Continues exact captures of all lights, for the flame of an image. They are then held, wherever it moves, until the next ones.
   *
   * Many drivers compile at a program's first draw, once more: it ends a frame's steps, and the next frame has none.
   *
   * @param steps how many: a face of a cube, or a band of a pass, each; none while a program compiles
   * @returns whether they are done
   */
  hold(frame: FrameInput, steps: number): boolean {
    // What is captured for another image is given up.
    if (this.#capturing !== frame.captureLight) this.#holding = null;
    this.#capturing = frame.captureLight;
    this.#holding ??= this.#holdingSteps(frame);
    const gpu = this.#gpu;
    const used = gpu.used.size;
    const isNew = used !== this.#programsUsed;
    this.#programsUsed = used;
    if (isNew) return false;
    for (let step = 0; step < steps && used === gpu.used.size && !gpu.isCompiling; step++) {
      if (!this.#holding.next().done) continue;
      this.#holding = null;
      return true;
    }
    return false;
  }

  *#holdingSteps({ world, captureLight }: FrameInput): Steps {
    yield* this.#lights(world);
    if (this.#heldFor(captureLight)) return;
    this.#held = { light: captureLight, captures: yield* this.#ofLight(captureLight) };
  }

  /** Captures that are held, if they serve a light. */
  #heldFor({ position, rimRadius, panRadius }: CaptureLight): FlameCaptures | null {
    if (!this.#held) return null;
    const { light, captures } = this.#held;
    // A hidden candle casts no shadow.
    const hasSameCandle = light.rimRadius === rimRadius && light.panRadius === panRadius;
    return hasSameCandle && vec3.distance(position, light.position) <= SWAY ? captures : null;
  }

  /** Shadow cube of a light, a face in each step; the one that is held, if it serves, or else in its place. */
  *shadow(light: CaptureLight): Steps<ShadowCube> {
    const held = this.#heldFor(light);
    if (held) return held.shadow;
    this.#held = null;
    const captureOrigin = light.position;
    const depth = yield* this.#shadow.update(this.#casters, captureOrigin);
    return { depth, captureOrigin, isNew: false };
  }

  *#ofLight(light: CaptureLight): Steps<FlameCaptures> {
    const shadow = yield* this.shadow(light);
    const irradiance = yield* this.#indirect.capture(this.#casters, light, shadow);
    return { shadow, irradiance };
  }

  /** Prepares the first frames in motion, a part of the model in each frame. */
  #prepareLods(): void {
    this.#shadowLod ??= this.#simplified(MOTION_ERROR.shadow);
    this.#surfelLod ??= this.#simplified(MOTION_ERROR.surfels);
  }

  #simplified(error: number): ShadowCasters | null {
    if (!this.#hasLods) return null;
    const detail = { error, isReduced: true };
    const { model, surfaces } = this.#room;
    return clustersOf(model, detail).proceed()
      ? new ShadowCasters(this.#gpu, model, surfaces, detail)
      : null;
  }
}
