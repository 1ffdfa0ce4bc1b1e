import gatherFrag from "../../../shaders/gi/gather.frag";
import rayDirectFrag from "../../../shaders/gi/ray-direct.frag";
import rayRadianceFrag from "../../../shaders/gi/ray-radiance.frag";
import surfelRadianceFrag from "../../../shaders/gi/surfel-radiance.frag";
import type { Model } from "../../assets/model.js";
import type { Draw, Gpu, Program, RenderTarget, ShaderSource, UniformBlock } from "../../gl/gpu.js";
import type { CollisionMesh } from "../../world/room/collision-mesh.js";
import { finish, type Steps } from "../../world/steps.js";
import { drawInBands } from "../draw-in-bands.js";
import type { CaptureLight } from "../light-block.js";
import type { Mesh } from "../mesh/mesh.js";
import { SCHEDULE } from "../schedule.js";
import { FACES } from "../shadow/cube-map.js";
import type { ShadowCasters } from "../shadow/shadow-casters.js";
import type { ShadowCube } from "../shadow/shadow-pass.js";
import { BounceLimit } from "./bounce-limit.js";
import {
  type IndirectTargets,
  irradianceMaps,
  rayRadianceTarget,
  surfelRowsOf,
} from "./indirect-targets.js";
import { type IrradianceVolume, volumeBlock } from "./irradiance-volume.js";
import { type IndirectDetail, IRRADIANCE_TEXELS, probeTraceOf } from "./probe-rays.js";
import { type ProbeTextures, uploadProbeRays } from "./probe-textures.js";
import { SurfelPass } from "./surfel-pass.js";
import type { Surfels } from "./surfels.js";

/** The room that reflects light. */
export interface IndirectScene {
  readonly model: Model;
  readonly collision: CollisionMesh;
  /** Of the model, in the order of its parts. */
  readonly surfaces: readonly Mesh[];
}

/** Bands that a pass is drawn in, where the capture is banded. */
const BANDS = { surfelRadiance: 9, rayDirect: 3, rayRadiance: 4, gather: 3 };
const AT_ONCE = { surfelRadiance: 1, rayDirect: 1, rayRadiance: 1, gather: 1 };
const PASS_BANDS = 40; // of `bouncesAfter`

export type ShadowMap = Pick<ShadowCube, "depth" | "captureOrigin">;

/**
 * Indirect diffuse light by radiosity and dynamic irradiance probes, without precomputed lighting.
 *
 * First bounce: surfels captured in a cube around the flame, and the hits of the probes' rays, combined by multiple
 * importance sampling. Further bounces: the probes' rays, lit by the irradiance volume. They start from darkness, so that
 * the result depends on the light's position alone; `twoBounces` starts from the previous result. All of it is for a
 * flame of 1 cd: flicker changes only a factor.
 */
export class IndirectPass {
  readonly #gpu: Gpu;
  readonly #detail: IndirectDetail;
  readonly #surfelRadianceProgram: Program;
  readonly #rayRadianceProgram: Program;
  readonly #rayDirectProgram: Program;
  readonly #surfelGatherProgram: Program;
  readonly #rayGatherProgram: Program;
  readonly #bands: typeof BANDS;
  readonly #block: UniformBlock;
  /** Of `lib/probe-rays.glsl`. */
  readonly #uniforms: Readonly<Record<"uRays" | "uProbeRows" | "uGroup" | "uSurfelRows", number>>;
  readonly #surfels: Surfels;
  readonly #targets: IndirectTargets;
  /** After all bounces. */
  readonly #irradiance: RenderTarget;
  readonly #limit: BounceLimit;
  readonly #scene: IndirectScene;
  #uploaded: ProbeTextures | null = null;
  /** Of the current irradiance; null before there is one. */
  lastLight: CaptureLight | null = null;
  /** Of the surfels, whose capture may still go on. */
  capturedFor: CaptureLight | null = null;
  #isExact = false;
  /** Of `bouncesAfter`: not shared, since other lights' bounces may come between its bands. */
  #passRadiance: RenderTarget | null = null;
  #revision = 0;
  /** Of the flame in this frame: the rays are lit past it. */
  shadow: ShadowMap | null = null;

  constructor(
    gpu: Gpu,
    scene: IndirectScene,
    detail: IndirectDetail,
    targets: IndirectTargets,
    surfels: Surfels = new SurfelPass(gpu, detail),
  ) {
    this.#gpu = gpu;
    this.#detail = detail;
    this.#scene = scene;
    this.#surfels = surfels;
    this.#targets = targets;
    this.#bands = detail.isBanded ? BANDS : AT_ONCE;
    this.#uniforms = {
      uRays: detail.rays,
      uProbeRows: detail.probes[1],
      uSurfelRows: surfelRowsOf(detail),
      uGroup: detail.surfelGroup,
    };
    const ofLight = (label: string, fragment: ShaderSource) =>
      gpu.pass(label, fragment, { defines: surfels.defines });
    this.#surfelRadianceProgram = ofLight("gi/surfel-radiance", surfelRadianceFrag);
    this.#rayRadianceProgram = gpu.pass("gi/ray-radiance", rayRadianceFrag);
    this.#rayDirectProgram = ofLight("gi/ray-direct", rayDirectFrag);
    this.#block = volumeBlock(gpu, this.#rayRadianceProgram, scene, detail);
    const gather = (SURFELS: 0 | 1, ROWS: number, COLUMNS: number) =>
      gpu.pass("gi/gather", gatherFrag, {
        defines: { SURFELS, ROWS, COLUMNS, IRRADIANCE_TEXELS },
      });
    this.#surfelGatherProgram = gather(1, this.#uniforms.uSurfelRows, detail.rays);
    this.#rayGatherProgram = gather(0, detail.rays / 2, detail.rays / 2);
    this.#irradiance = irradianceMaps(gpu, detail, "gi/irradiance");
    this.#limit = new BounceLimit(gpu);
  }

  get #probes(): ProbeTextures {
    this.#uploaded ??= this.#upload();
    finish(this.#uploaded.drawing);
    return this.#uploaded;
  }

  /** Uploaded on first use: their albedo waits for a program. */
  #upload(): ProbeTextures {
    const { collision, model, surfaces } = this.#scene;
    const rays = probeTraceOf(collision, model, this.#detail).finish();
    return this.#gpu.share(rays, () =>
      uploadProbeRays(this.#gpu, this.#block, rays, this.#detail, surfaces),
    );
  }

  /**
   * Indirect light for each candela of the flame's.
   *
   * @param light members of the block of `lib/flame-light.glsl`, of a flame at its capture origin
   */
  *capture(
    casters: ShadowCasters,
    light: CaptureLight,
    shadow: ShadowMap,
  ): Steps<IrradianceVolume> {
    this.shadow = shadow;
    if (this.#detail.isBanded || !this.isKnown(light, true)) {
      yield* this.captureSurfels(casters, light);
      yield* this.allBounces(light);
    }
    return this.volume;
  }

  /** A face of the surfel cube in each step. */
  *captureSurfels(casters: ShadowCasters, light: CaptureLight): Steps {
    this.#isExact = false;
    this.capturedFor = light;
    const { collision, model } = this.#scene;
    const trace = probeTraceOf(collision, model, this.#detail);
    while (!trace.proceed(SCHEDULE.probesPerFrame)) yield;
    // Not delegated: others go on with it where these steps are given up.
    const { drawing } = this.#upload();
    while (!drawing.next().done) yield;
    yield* casters.prepareAlbedo();
    for (const face of FACES.keys()) {
      this.#surfels.capture(casters, light.position, face);
      yield;
    }
  }

  /** Whether the irradiance is that of this light; `isExact`: and all bounces are computed. */
  isKnown(light: CaptureLight, isExact: boolean): boolean {
    return (this.#isExact || !isExact) && JSON.stringify(light) === JSON.stringify(this.lastLight);
  }

  /** Whether the bounces that were last begun are those of this light. */
  hasBegun(light: CaptureLight): boolean {
    return this.#targets.usedFor === light;
  }

  get volume(): IrradianceVolume {
    return {
      block: this.#block,
      textures: { uIrradiance: this.#irradiance.color, ...this.#probes.volume },
      surfels: {
        uSurfelNormalDistance: this.#surfels.normalDistance,
        uTotalRadiosity: this.#surfels.totalRadiosity,
      },
      roomReflectance: this.#probes.roomReflectance,
      support: this.#surfels.support,
      revision: this.#revision,
    };
  }

  *allBounces(light: CaptureLight): Steps {
    yield* this.#renderFirstBounce(light);
    yield* this.#renderFurtherBounces(this.#irradiance);
    this.#revision++;
    this.#surfels.renderTotalRadiosity(this.volume.textures, this.#block);
    this.lastLight = light;
    this.#isExact = true;
  }

  /**
   * What light does after a bounce that a pass finds at the hits of the probes' rays.
   *
   * @param pass draws its radiance times solid angle, as gi/ray-radiance does
   * @param target irradiance, lx
   */
  *bouncesAfter(pass: Omit<Draw, "target">, target: RenderTarget): Steps {
    this.#passRadiance ??= rayRadianceTarget(this.#gpu, this.#detail);
    yield* drawInBands(this.#gpu, PASS_BANDS, {
      ...pass,
      target: this.#passRadiance,
      textures: {
        ...pass.textures,
        ...this.#probes.rays,
        uProbePositions: this.#probes.volume.uProbePositions,
      },
      uniforms: this.#uniforms,
    });
    const light = this.lastLight;
    do {
      this.#targets.usedFor = light;
      const rest = this.#bouncesFrom(this.#passRadiance, target);
      if (this.#detail.isBanded) yield* rest;
      else finish(rest);
    } while (this.#targets.usedFor !== light); // another's have come in between
  }

  *#bouncesFrom(radiance: RenderTarget, target: RenderTarget): Steps {
    const { firstBounce, bounces } = this.#targets;
    const [nothing] = bounces;
    this.#gpu.clear(nothing!, [0, 0, 0, 1]);
    yield* this.#gatherRays(radiance, nothing!, firstBounce);
    yield* this.#renderFurtherBounces(target);
  }

  /** The limit of what begins with the targets' first bounce. */
  *#renderFurtherBounces(target: RenderTarget): Steps {
    const sums = [this.#targets.firstBounce];
    for (let bounce = 1; bounce < this.#detail.bounces; bounce++) {
      const sum = this.#targets.bounces[bounce % this.#targets.bounces.length]!;
      yield* this.#renderNextBounce(sums.at(-1)!, sum);
      sums.push(sum);
    }
    this.#limit.render(sums.slice(-4), target);
  }

  /** The first bounce, and one of the previous irradiance, which approximates all further bounces. */
  *twoBounces(light: CaptureLight): Steps {
    yield* this.#renderFirstBounce(light);
    yield* this.#renderNextBounce(this.#irradiance, this.#irradiance);
    this.lastLight = light;
    this.#revision++;
    if (!this.#detail.mirrorsInMotion) return;
    this.#surfels.renderTotalRadiosity(this.volume.textures, this.#block);
  }

  *#renderFirstBounce(light: CaptureLight): Steps {
    this.#targets.usedFor = light;
    this.#surfels.renderRadiosity(light);
    yield;
    const { normalDistance: uSurfelNormalDistance, radiosity: uRadiosity } = this.#surfels;
    const { uProbePositions } = this.#probes.volume;
    yield* drawInBands(this.#gpu, this.#bands.surfelRadiance, {
      blocks: this.#surfels.blocks,
      program: this.#surfelRadianceProgram,
      uniforms: this.#uniforms,
      target: this.#targets.surfelRadiance,
      textures: {
        uSurfelNormalDistance,
        uRadiosity,
        uRayHits: this.#probes.rays.uRayHits,
        uProbePositions,
        ...this.#surfels.visibility,
      },
    });
    const [surfelSum] = this.#targets.bounces;
    const [uRadiance, uDirection] = this.#targets.surfelRadiance.colors;
    yield* drawInBands(this.#gpu, this.#bands.gather, {
      program: this.#surfelGatherProgram,
      uniforms: this.#uniforms,
      target: surfelSum!,
      textures: { uRadiance: uRadiance!, uDirection: uDirection! },
    });
    const shadow = this.shadow!;
    yield* drawInBands(this.#gpu, this.#bands.rayDirect, {
      blocks: this.#surfels.blocks,
      program: this.#rayDirectProgram,
      target: this.#targets.rayRadiance,
      textures: {
        uSurfelNormalDistance,
        uProbePositions,
        ...this.#probes.rays,
        uShadow: shadow.depth,
      },
      uniforms: { ...this.#uniforms, uShadowOrigin: shadow.captureOrigin },
    });
    const { rayRadiance, firstBounce } = this.#targets;
    yield* this.#gatherRays(rayRadiance, surfelSum!, firstBounce);
  }

  *#renderNextBounce(last: RenderTarget, target: RenderTarget): Steps {
    const { rayRadiance, firstBounce } = this.#targets;
    yield* drawInBands(this.#gpu, this.#bands.rayRadiance, {
      program: this.#rayRadianceProgram,
      uniforms: this.#uniforms,
      target: rayRadiance,
      textures: {
        uIrradiance: last.color,
        ...this.#probes.rays,
        uRayProbes: this.#probes.uRayProbes,
      },
      blocks: { Volume: this.#block },
    });
    yield* this.#gatherRays(rayRadiance, firstBounce, target);
  }

  /** The probes' irradiance before, plus that along their rays. */
  *#gatherRays(radiance: RenderTarget, before: RenderTarget, target: RenderTarget): Steps {
    yield* drawInBands(this.#gpu, this.#bands.gather, {
      program: this.#rayGatherProgram,
      uniforms: this.#uniforms,
      target,
      textures: { uRadiance: radiance.color, uIrradianceBefore: before.color },
    });
  }
}
