import gatherFrag from "../../../shaders/gi/gather.frag";
import rayDirectFrag from "../../../shaders/gi/ray-direct.frag";
import rayRadianceFrag from "../../../shaders/gi/ray-radiance.frag";
import surfelRadianceFrag from "../../../shaders/gi/surfel-radiance.frag";
import fullscreenVert from "../../../shaders/post/fullscreen.vert";
import type { Model } from "../../assets/model.js";
import type { Gpu } from "../../gl/gpu.js";
import type { Program, ShaderSource } from "../../gl/program.js";
import type { RenderTarget } from "../../gl/render-target.js";
import type { Texture } from "../../gl/texture.js";
import type { UniformBlock } from "../../gl/uniform-block.js";
import type { CollisionMesh } from "../../world/room/collision-mesh.js";
import type { CaptureLight } from "../light-block.js";
import type { Mesh } from "../mesh/mesh.js";
import { SCHEDULE } from "../schedule.js";
import { FACES } from "../shadow/cube-map.js";
import type { ShadowCasters } from "../shadow/shadow-casters.js";
import type { ShadowCube } from "../shadow/shadow-pass.js";
import { drawInBands, finish, type Steps } from "../steps.js";
import { BounceLimit } from "./bounce-limit.js";
import {
  type IndirectTargets,
  indirectTargets,
  irradianceMaps,
  surfelRowsOf,
} from "./indirect-targets.js";
import { interiorBounds } from "./interior-bounds.js";
import { type IndirectDetail, IRRADIANCE_TEXELS, traceProbes } from "./probe-rays.js";
import { type ProbeTextures, uploadProbeRays } from "./probe-textures.js";
import { SurfelPass, type Surfels } from "./surfel-pass.js";

/** The room that reflects light. */
export interface IndirectScene {
  readonly model: Model;
  readonly collision: CollisionMesh;
  /** Of the model, in the order of its parts. */
  readonly surfaces: readonly Mesh[];
}

/** Bands that a pass is drawn in, where it is drawn in steps. */
const BANDS = { surfelRadiance: 9, rayDirect: 3, rayRadiance: 4, gather: 3 };
const AT_ONCE: typeof BANDS = { surfelRadiance: 1, rayDirect: 1, rayRadiance: 1, gather: 1 };
/** Bias along the normal, for the visibility of probes, as a share of their least spacing. */
const NORMAL_BIAS = 0.15;

type ShadowMap = Pick<ShadowCube, "depth" | "captureOrigin">;

/** How small the steps of a capture are: `IndirectPass.passes` or `IndirectPass.steps`. */
export type StepSize = "passes" | "steps";

/** Irradiance volume, for shaders that include `lib/irradiance-volume.glsl`. */
export interface IrradianceVolume {
  readonly block: UniformBlock;
  readonly textures: {
    readonly uIrradiance: Texture;
    readonly uProbePositions: Texture;
    readonly uProbeDepth: Texture;
  };
  /** The surfels, and their light, which surfaces mirror: for `lib/distance-impostor.glsl`. */
  readonly surfels: {
    readonly uSurfelNormalDistance: Texture;
    /** In all light, lm/m². */
    readonly uTotalRadiosity: Texture;
  };
  /** Mean reflectance of the room, one texel: for the exposure. */
  readonly roomReflectance: Texture;
  /** Of the surface below the flame, for `lib/support-irradiance.glsl`. */
  readonly support: Texture;
  /** Changes with any of these. */
  readonly revision: number;
}

/**
 * Indirect diffuse light by radiosity and dynamic irradiance probes, without precomputed lighting.
 *
 * First bounce: surfels captured in a cube around the flame, and the hits of the probes' rays, combined by multiple
 * importance sampling. Further bounces: the probes' rays, lit by the irradiance volume. `render` starts from darkness,
 * so its result depends on the light's position alone; `updateIncrementally` starts from the previous result. All of
 * it is for a flame of 1 cd: flicker changes only a factor.
 */
export class IndirectPass {
  readonly #gpu: Gpu;
  readonly #detail: IndirectDetail;
  readonly #surfelRadianceProgram: Program;
  readonly #rayRadianceProgram: Program;
  readonly #rayDirectProgram: Program;
  readonly #surfelGatherProgram: Program;
  readonly #rayGatherProgram: Program;
  readonly #block: UniformBlock;
  readonly #surfels: Surfels;
  readonly #targets: IndirectTargets;
  /** After all bounces. */
  readonly #irradiance: RenderTarget;
  readonly #limit: BounceLimit;
  readonly #scene: IndirectScene;
  #uploaded: ProbeTextures | null = null;
  /** Light of the current irradiance, as JSON. */
  #lastLight = "";
  /** Whether the irradiance was computed by `render`. */
  #isExact = false;
  #revision = 0;
  /** Incremental update in progress, with the number of faces captured so far. */
  #update: { readonly light: CaptureLight; faces: number; hasWaited: boolean } | null = null;
  /** Frames until the next incremental update may begin. */
  #pause = 0;

  constructor(
    gpu: Gpu,
    scene: IndirectScene,
    detail: IndirectDetail,
    {
      surfels = new SurfelPass(gpu, detail),
      targets = indirectTargets(gpu, detail),
    }: { readonly surfels?: Surfels; readonly targets?: IndirectTargets } = {},
  ) {
    this.#gpu = gpu;
    this.#detail = detail;
    this.#scene = scene;
    this.#surfels = surfels;
    this.#targets = targets;
    const surfelRows = surfelRowsOf(detail);
    const tile = { RAYS: detail.rays, PROBE_ROWS: detail.probes[1] };
    const perRay = (label: string, fragment: ShaderSource) =>
      gpu.program(label, fullscreenVert, fragment, {
        defines: {
          ...tile,
          SURFEL_ROWS: surfelRows,
          GROUP: detail.surfelGroup,
          ...surfels.defines,
        },
      });
    this.#surfelRadianceProgram = perRay("gi/surfel-radiance", surfelRadianceFrag);
    this.#rayRadianceProgram = perRay("gi/ray-radiance", rayRadianceFrag);
    this.#rayDirectProgram = perRay("gi/ray-direct", rayDirectFrag);
    const [columns, rows, planes] = detail.probes;
    const { min, max } = interiorBounds(scene.collision, scene.model);
    this.#block = gpu.uniformBlock(this.#rayRadianceProgram, "Volume");
    this.#block.update({
      corner: min,
      // A floor without walls has no height.
      extent: min.map((low, axis) => Math.max((max[axis] ?? low) - low, 0.01)),
      columns,
      rows,
      planes,
      inset: detail.inset,
      bias:
        NORMAL_BIAS *
        Math.min(...detail.probes.map((n, axis) => ((max[axis] ?? 0) - (min[axis] ?? 0)) / n)),
    });
    const gather = (SURFELS: 0 | 1, ROWS: number, COLUMNS: number) =>
      gpu.program("gi/gather", fullscreenVert, gatherFrag, {
        defines: { ...tile, SURFELS, ROWS, COLUMNS, IRRADIANCE_TEXELS },
      });
    this.#surfelGatherProgram = gather(1, surfelRows, detail.rays);
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
    const rays = traceProbes(collision, model, this.#detail);
    return this.#gpu.share(rays, () =>
      uploadProbeRays(this.#gpu, this.#block, rays, this.#detail, surfaces),
    );
  }

  /**
   * Indirect light for each candela of the flame's, a pass in each step.
   *
   * @param light members of the block of `lib/flame-light.glsl`, of a flame at its capture origin
   */
  *passes(casters: ShadowCasters, light: CaptureLight, shadow: ShadowMap): Steps<IrradianceVolume> {
    this.#update = null;
    if (!this.#isExact || JSON.stringify(light) !== this.#lastLight) {
      yield* this.#allSteps(casters, light, shadow, AT_ONCE);
    }
    return this.#volume;
  }

  /** The same in smaller steps: a face of the surfel cube, or a band of a pass, in each. */
  *steps(casters: ShadowCasters, light: CaptureLight, shadow: ShadowMap): Steps<IrradianceVolume> {
    yield* this.#allSteps(casters, light, shadow, BANDS);
    return this.#volume;
  }

  *#allSteps(
    casters: ShadowCasters,
    light: CaptureLight,
    shadow: ShadowMap,
    bands: typeof BANDS,
  ): Steps {
    this.#isExact = false;
    yield* this.#upload().drawing;
    yield* casters.prepareAlbedo();
    this.#surfels.clear();
    for (const face of FACES.keys()) {
      this.#surfels.capture(casters, light.position, face);
      yield;
    }
    yield* this.#renderBounces(light, shadow, bands);
  }

  /**
   * Amortised update for a moving light: one face of the surfel cube, or one bounce, in each frame.
   *
   * @param isBusy whether this frame takes long anyway: a bounce waits for the next one
   */
  updateIncrementally(
    casters: ShadowCasters,
    light: CaptureLight,
    shadow: ShadowMap,
    isBusy = false,
  ): IrradianceVolume {
    if (this.#lastLight === "") {
      finish(this.passes(casters, light, shadow));
      this.#isExact = false; // the casters may be of a lower level of detail
      return this.#volume;
    }
    if (!this.#update) {
      if (this.#pause-- > 0 || JSON.stringify(light) === this.#lastLight) return this.#volume;
      this.#update = { light, faces: 0, hasWaited: false };
      this.#surfels.clear();
    }
    if (this.#update.faces < FACES.length) {
      this.#surfels.capture(casters, this.#update.light.position, this.#update.faces++);
    } else if (isBusy && !this.#update.hasWaited) {
      this.#update.hasWaited = true;
    } else if (this.#targets.firstBounceOf !== this.#update.light) {
      // Not computed yet, or another light's captures have come in between.
      finish(this.#renderFirstBounce(this.#update.light, shadow, AT_ONCE));
      this.#update.hasWaited = false;
    } else {
      this.#updateFurtherBounces(this.#update.light);
      this.#update = null;
      this.#pause = SCHEDULE.indirect.restFrames;
    }
    return this.#volume;
  }

  get #volume(): IrradianceVolume {
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

  *#renderBounces(light: CaptureLight, shadow: ShadowMap, bands: typeof BANDS): Steps {
    yield* this.#renderFirstBounce(light, shadow, bands);
    const sums = [this.#targets.firstBounce];
    for (let bounce = 1; bounce < this.#detail.bounces; bounce++) {
      const sum = this.#targets.bounces[bounce % this.#targets.bounces.length]!;
      yield* this.#renderNextBounce(sums.at(-1)!, sum, bands);
      sums.push(sum);
      yield;
    }
    this.#limit.render(sums.slice(-4), this.#irradiance);
    this.#revision++;
    this.#surfels.renderTotalRadiosity(this.#volume.textures, this.#block);
    this.#lastLight = JSON.stringify(light);
    this.#isExact = true;
  }

  /** One bounce of the previous irradiance approximates all further bounces. */
  #updateFurtherBounces(light: CaptureLight): void {
    this.#lastLight = JSON.stringify(light);
    this.#isExact = false;
    finish(this.#renderNextBounce(this.#irradiance, this.#irradiance, AT_ONCE));
    this.#revision++;
    if (!this.#detail.mirrorsInMotion) return;
    this.#surfels.renderTotalRadiosity(this.#volume.textures, this.#block);
  }

  *#renderFirstBounce(light: CaptureLight, shadow: ShadowMap, bands: typeof BANDS): Steps {
    this.#targets.firstBounceOf = null;
    this.#surfels.renderRadiosity(light);
    yield;
    const { normalDistance: uSurfelNormalDistance, radiosity: uRadiosity } = this.#surfels;
    const { uProbePositions } = this.#probes.volume;
    yield* drawInBands(this.#gpu, bands.surfelRadiance, {
      blocks: this.#surfels.light,
      program: this.#surfelRadianceProgram,
      target: this.#targets.surfelRadiance,
      textures: {
        uSurfelNormalDistance,
        uRadiosity,
        uRayHits: this.#probes.rays.uRayHits,
        uProbePositions,
      },
    });
    const [surfelSum] = this.#targets.bounces;
    const [uRadiance, uDirection] = this.#targets.surfelRadiance.colors;
    yield* drawInBands(this.#gpu, bands.gather, {
      program: this.#surfelGatherProgram,
      target: surfelSum!,
      textures: { uRadiance: uRadiance!, uDirection: uDirection! },
    });
    yield* drawInBands(this.#gpu, bands.rayDirect, {
      blocks: this.#surfels.light,
      program: this.#rayDirectProgram,
      target: this.#targets.rayRadiance,
      textures: {
        uSurfelNormalDistance,
        uProbePositions,
        ...this.#probes.rays,
        uShadow: shadow.depth,
      },
      uniforms: { uShadowOrigin: shadow.captureOrigin },
    });
    yield* this.#gatherRays(surfelSum!, this.#targets.firstBounce, bands);
    this.#targets.firstBounceOf = light;
  }

  *#renderNextBounce(last: RenderTarget, target: RenderTarget, bands: typeof BANDS): Steps {
    yield* drawInBands(this.#gpu, bands.rayRadiance, {
      program: this.#rayRadianceProgram,
      target: this.#targets.rayRadiance,
      textures: {
        uIrradiance: last.color,
        ...this.#probes.rays,
        uRayProbes: this.#probes.uRayProbes,
      },
      blocks: { Volume: this.#block },
    });
    yield* this.#gatherRays(this.#targets.firstBounce, target, bands);
  }

  /** The probes' irradiance before, plus that along their rays. */
  *#gatherRays(before: RenderTarget, target: RenderTarget, bands: typeof BANDS): Steps {
    yield* drawInBands(this.#gpu, bands.gather, {
      program: this.#rayGatherProgram,
      target,
      textures: { uRadiance: this.#targets.rayRadiance.color, uIrradianceBefore: before.color },
    });
  }
}
