import type { Gpu, Texture } from "../../gl/gpu.js";
import { adaptedMoonlight } from "../../light/moonlight.js";
import type { Vec3 } from "../../world/geometry.js";
import type { Moon } from "../../world/moon.js";
import { CollisionMesh } from "../../world/room/collision-mesh.js";
import type { Steps } from "../../world/steps.js";
import { type CachedLight, moonKey } from "../cached-light.js";
import { IndirectPass, type IndirectScene } from "../gi/indirect-pass.js";
import type { IndirectTargets } from "../gi/indirect-targets.js";
import { lightRays } from "../gi/light-rays.js";
import { type IndirectDetail, probeTraceOf } from "../gi/probe-rays.js";
import type { PhysicalTier } from "../quality.js";
import { SCHEDULE } from "../schedule.js";
import { clustersOf, ShadowCasters } from "../shadow/shadow-casters.js";
import { entersRoom } from "./entry.js";
import {
  clipFromFrustum,
  type MoonFrustum,
  moonBlock,
  moonCasters,
  moonFrustum,
  SKY,
} from "./moon-frustum.js";
import { MoonSurfels } from "./moon-surfels.js";
import { panesOf } from "./panes.js";
import {
  moonlitPoints,
  type SurfelVisibility,
  traceSurfelVisibility,
} from "./surfel-visibility.js";
import { type LitPoint, VirtualLights, type VirtualLightTextures } from "./virtual-lights.js";

/** What is captured for a direction. */
interface Prepared {
  readonly frustum: MoonFrustum;
  readonly casters: ShadowCasters;
  readonly lit: readonly (LitPoint | null)[];
  readonly visibility: SurfelVisibility;
}

type Captured = Omit<CachedLight, "intensity" | "key">;

/** The moon's map and irradiance volume, captured once for each direction of its light. */
export class MoonCaptures {
  readonly #gpu: Gpu;
  readonly #scene: IndirectScene;
  readonly #map: Texture;
  readonly #surfels: MoonSurfels;
  readonly #detail: IndirectDetail;
  readonly #indirect: IndirectPass;
  /** What the moon lights, of each of its surfels. */
  #lit: readonly (LitPoint | null)[] = [];
  /** Made when the moon first is all that shines. */
  #virtual: VirtualLights | null = null;
  #capturing: Steps<VirtualLightTextures> | null = null;
  #key = "";
  /** The direction to come. A frame may go on with it where another was abandoned. */
  #next: { readonly key: string; readonly steps: Steps<Captured | null> } | null = null;
  #light: (Captured & Pick<CachedLight, "key">) | null = null;

  constructor(
    gpu: Gpu,
    scene: IndirectScene,
    { moonMap, indirect }: PhysicalTier,
    targets: IndirectTargets,
  ) {
    this.#gpu = gpu;
    this.#scene = scene;
    this.#map = gpu.texture({
      label: "moon/map",
      format: "DEPTH_COMPONENT16",
      source: { width: moonMap, height: moonMap },
      filter: "nearest",
    });
    this.#detail = indirect;
    this.#surfels = new MoonSurfels(gpu, indirect.surfels, indirect.surfelGroup);
    this.#indirect = new IndirectPass(gpu, scene, indirect, targets, this.#surfels);
  }

  /**
   * Null where it does not reach the room.
   *
   * @param isGradual whether a new direction is prepared a little in each call, and the last one shines until then
   */
  *light({ direction, illuminance }: Moon, isGradual: boolean): Steps<CachedLight | null> {
    const key = moonKey(direction);
    const isWaiting = isGradual && this.#key !== "";
    // The direction to come was taken back.
    if (key === this.#key && this.#next) {
      this.#next.steps.return(null);
      this.#next = null;
    }
    while (key !== this.#key) {
      if (this.#next?.key !== key && !isWaiting) {
        this.#next?.steps.return(null);
        this.#next = null;
      }
      this.#next ??= { key, steps: this.#steps(direction) };
      const next = this.#next;
      const { done, value } = next.steps.next();
      if (done) {
        this.#next = null;
        this.#light = value && { ...value, key: next.key };
        this.#key = next.key;
      }
      // Once it is being captured, the last one is gone.
      if (isWaiting && this.#key !== "") break;
      yield;
    }
    return this.#light && { ...this.#light, intensity: adaptedMoonlight(illuminance) };
  }

  /**
   * What the moon's light alone needs: virtual lights.
   *
   * @param casters of the whole room
   */
  *night(casters: ShadowCasters): Steps {
    if (!this.#light || this.#light.virtual) return;
    this.#virtual ??= new VirtualLights(this.#gpu, this.#surfels, this.#indirect, this.#detail);
    this.#capturing ??= this.#virtual.capture(casters, this.#lit);
    // Another frame may go on with it between these steps, or another direction replace it.
    while (this.#capturing && this.#light && !this.#light.virtual) {
      const { done, value } = this.#capturing.next();
      if (done) this.#light = { ...this.#light, virtual: value };
      else yield;
    }
  }

  *#steps(direction: Vec3): Steps<Captured | null> {
    const prepared = yield* this.#prepare(direction);
    // It replaces the last direction's.
    this.#key = "";
    this.#light = null;
    if (!prepared) return null;
    try {
      return yield* this.#capture(prepared);
    } finally {
      prepared.casters.dispose();
    }
  }

  /** What the script computes for a direction; null where its light does not reach the room. */
  *#prepare(direction: Vec3): Steps<Prepared | null> {
    const { model, surfaces, collision } = this.#scene;
    const frustum = moonFrustum(direction, model.bounds, panesOf(model));
    const parts = moonCasters(model.parts, frustum);
    const blockers = new CollisionMesh(parts);
    if (!frustum.panes && !entersRoom(direction, blockers, model.bounds)) return null;
    const before = { ...model, parts };
    const detail = { error: 0 };
    while (!clustersOf(before, detail).proceed()) yield;
    const lit = moonlitPoints(frustum, blockers, this.#detail);
    const trace = probeTraceOf(collision, model, this.#detail);
    while (!trace.proceed(SCHEDULE.probesPerFrame)) yield;
    const { positions } = trace.finish();
    const light = lightRays(collision, model.parts);
    const visibility = yield* traceSurfelVisibility(lit, light, positions, this.#detail);
    const casters = new ShadowCasters(this.#gpu, before, surfaces, detail);
    return { frustum, casters, lit, visibility };
  }

  *#capture({ frustum, casters, lit, visibility }: Prepared): Steps<Captured> {
    this.#drawMap(frustum, casters);
    yield;
    this.#capturing = null;
    this.#lit = lit;
    this.#surfels.prepare(frustum, visibility);
    const block = moonBlock(frustum, this.#surfels.detail);
    const shadow = { depth: this.#map, captureOrigin: frustum.corner };
    const irradiance = yield* this.#indirect.capture(casters, block, shadow);
    return {
      kind: "moon",
      name: "moon",
      light: null,
      block: this.#surfels.block,
      shadow: this.#map,
      irradiance,
      virtual: null,
      // The sky shows through openings. In a room with panes, background is a gap between walls.
      background: frustum.panes ? 0 : SKY,
    };
  }

  #drawMap(frustum: MoonFrustum, casters: ShadowCasters): void {
    const target = this.#gpu.textureView({
      label: "moon/map",
      textures: [],
      depth: this.#map,
    });
    this.#gpu.clear(target, [0, 0, 0, 0]);
    casters.drawDepth({ target, uClipFromWorld: clipFromFrustum(frustum) }, () => true);
    target.dispose();
  }
}
