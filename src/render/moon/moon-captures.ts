import shadowFrag from "../../../shaders/shadow/shadow.frag";
import shadowVert from "../../../shaders/shadow/shadow.vert";
import type { Part } from "../../assets/model.js";
import type { Gpu } from "../../gl/gpu.js";
import type { Texture } from "../../gl/texture.js";
import { adaptedMoonlight } from "../../light/moonlight.js";
import type { Vec3 } from "../../world/geometry.js";
import type { Moon } from "../../world/moon.js";
import { CollisionMesh } from "../../world/room/collision-mesh.js";
import type { CachedLight } from "../cached-light.js";
import { IndirectPass, type IndirectScene, type StepSize } from "../gi/indirect-pass.js";
import type { IndirectTargets } from "../gi/indirect-targets.js";
import { type IndirectDetail, traceProbes } from "../gi/probe-rays.js";
import type { PhysicalTier } from "../quality.js";
import { clusterIncrementally, ShadowCasters } from "../shadow/shadow-casters.js";
import type { Steps } from "../steps.js";
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
import { type SurfelVisibility, traceSurfelVisibility } from "./surfel-visibility.js";

/** The moon's map and irradiance volume, captured once for each direction of its light. */
export class MoonCaptures {
  readonly #gpu: Gpu;
  readonly #scene: IndirectScene;
  readonly #map: Texture;
  readonly #surfels: MoonSurfels;
  readonly #detail: IndirectDetail;
  readonly #indirect: IndirectPass;
  #key = "";
  #light: Omit<CachedLight, "intensity"> | null = null;

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
    this.#indirect = new IndirectPass(gpu, scene, indirect, {
      surfels: this.#surfels,
      targets,
    });
  }

  /** Null where it does not reach the room. */
  *light({ direction, illuminance }: Moon, size: StepSize): Steps<CachedLight | null> {
    const key = JSON.stringify(direction);
    if (key !== this.#key) {
      const captured = yield* this.#capture(direction, size);
      this.#light = captured && { ...captured, key };
      this.#key = key;
    }
    return this.#light && { ...this.#light, intensity: adaptedMoonlight(illuminance) };
  }

  *#capture(direction: Vec3, size: StepSize): Steps<Omit<CachedLight, "intensity" | "key"> | null> {
    const { model, surfaces } = this.#scene;
    const frustum = moonFrustum(direction, model.bounds, panesOf(model));
    const parts = moonCasters(model.parts, frustum);
    if (!frustum.panes && !entersRoom(direction, parts, model.bounds)) return null;
    const before = { ...model, parts };
    const detail = { error: 0 };
    while (!clusterIncrementally(before, detail)) yield;
    const casters = new ShadowCasters(this.#gpu, before, surfaces, detail);
    this.#drawMap(frustum, casters);
    yield;
    this.#surfels.prepare(frustum, yield* this.#traceVisibility(frustum, parts));
    const block = moonBlock(frustum, this.#surfels.detail);
    const shadow = { depth: this.#map, captureOrigin: frustum.corner };
    const irradiance = yield* this.#indirect[size](casters, block, shadow);
    casters.dispose();
    return {
      kind: "moon",
      name: "moon",
      light: null,
      block: this.#surfels.light.Moon,
      shadow: this.#map,
      irradiance,
      // The sky shows through openings. In a room with panes, background is a gap between walls.
      background: frustum.panes ? 0 : SKY,
    };
  }

  *#traceVisibility(frustum: MoonFrustum, parts: readonly Part[]): Steps<SurfelVisibility> {
    const { collision, model } = this.#scene;
    const { positions } = traceProbes(collision, model, this.#detail);
    const meshes = { casters: new CollisionMesh(parts), room: collision };
    return yield* traceSurfelVisibility(frustum, meshes, positions, this.#detail);
  }

  #drawMap(frustum: MoonFrustum, casters: ShadowCasters): void {
    const target = this.#gpu.textureView({
      label: "moon/map",
      textures: [],
      image: 0,
      depth: this.#map,
    });
    this.#gpu.clear(target, [0, 0, 0, 0]);
    casters.draw(
      {
        program: this.#gpu.program("shadow/shadow", shadowVert, shadowFrag),
        target,
        uniforms: { uClipFromWorld: clipFromFrustum(frustum) },
        depth: "test-and-write",
        cull: "none",
      },
      () => true,
    );
    target.dispose();
  }
}
