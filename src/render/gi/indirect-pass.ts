import { mat4 } from "gl-matrix";
import gatherRaysFrag from "../../../shaders/gi/gather-rays.frag";
import gatherSurfelsFrag from "../../../shaders/gi/gather-surfels.frag";
import radiosityFrag from "../../../shaders/gi/radiosity.frag";
import rayDirectFrag from "../../../shaders/gi/ray-direct.frag";
import rayRadianceFrag from "../../../shaders/gi/ray-radiance.frag";
import supportFrag from "../../../shaders/gi/support-radiosity.frag";
import surfelFrag from "../../../shaders/gi/surfel.frag";
import fullscreenVert from "../../../shaders/post/fullscreen.vert";
import cubeFaceVert from "../../../shaders/shadow/cube-face.vert";
import type { Model } from "../../assets/model.js";
import type { Gpu } from "../../gl/gpu.js";
import type { Program, ShaderSource } from "../../gl/program.js";
import type { RenderTarget } from "../../gl/render-target.js";
import type { Texture } from "../../gl/texture.js";
import type { UniformBlock } from "../../gl/uniform-block.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import type { Vec3 } from "../../world/geometry.js";
import type { CollisionMesh } from "../../world/room/collision-mesh.js";
import { floats } from "../float-format.js";
import type { CaptureLight } from "../light-block.js";
import type { Mesh } from "../mesh/mesh.js";
import { SCHEDULE } from "../schedule.js";
import { clipFromFace, FACES } from "../shadow/cube-map.js";
import type { ShadowCasters } from "../shadow/shadow-casters.js";
import { harmonicsOf, IrradianceConvolution } from "./irradiance-convolution.js";
import { type ProbeDetail, SH_TEXELS, traceProbes } from "./probe-rays.js";
import { type ProbeTextures, uploadProbeRays } from "./probe-textures.js";

/** Resolution of indirect light. */
export interface IndirectDetail extends ProbeDetail {
  /** Surfels along an edge of the cube around the flame. */
  readonly surfels: number;
  readonly bounces: number;
  /** Whether probes are weighted by their visibility; otherwise by distance alone. */
  readonly testsVisibility: boolean;
}

/** The room that reflects light. */
export interface IndirectScene {
  readonly model: Model;
  readonly collision: CollisionMesh;
  /** Of the model, in the order of its parts. */
  readonly surfaces: readonly Mesh[];
}

/** Irradiance volume, for shaders that include `lib/irradiance-volume.glsl`. */
export interface IrradianceVolume {
  readonly block: UniformBlock;
  readonly textures: {
    readonly uIrradiance: Texture;
    readonly uProbePositions: Texture;
    readonly uProbeDepth: Texture;
  };
  /** Of the surfels, lm/m²: for `lib/distance-impostor.glsl`. */
  readonly radiosity: Texture;
  /** Of the surface below the flame, for `lib/support-irradiance.glsl`; null where probes test visibility. */
  readonly support: Texture | null;
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
  readonly #surfelProgram: Program;
  readonly #radiosityProgram: Program;
  readonly #gatherSurfelsProgram: Program;
  readonly #rayRadianceProgram: Program;
  readonly #rayDirectProgram: Program;
  readonly #gatherRaysProgram: Program;
  readonly #screen: VertexArray;
  readonly #block: UniformBlock;
  readonly #support: { readonly program: Program; readonly target: RenderTarget } | null;
  readonly #surfels: RenderTarget;
  readonly #radiosity: RenderTarget;
  readonly #rayRadiance: RenderTarget;
  readonly #firstBounce: RenderTarget;
  /** Radiance after each further bounce, used in turn. */
  readonly #bounces: readonly [RenderTarget, RenderTarget, RenderTarget];
  readonly #convolution: IrradianceConvolution;
  readonly #light: UniformBlock;
  readonly #scene: IndirectScene;
  #uploaded: ProbeTextures | null = null;
  /** Light of the current irradiance, as JSON. */
  #lastLight = "";
  /** Whether the irradiance was computed by `render`. */
  #isExact = false;
  /** Incremental update in progress, with the number of faces captured so far. */
  #update: { readonly light: CaptureLight; faces: number } | null = null;
  /** Frames until the next incremental update may begin. */
  #pause = 0;

  constructor(gpu: Gpu, screen: VertexArray, scene: IndirectScene, detail: IndirectDetail) {
    this.#gpu = gpu;
    this.#screen = screen;
    this.#detail = detail;
    this.#scene = scene;
    const perRay = (label: string, fragment: ShaderSource) =>
      gpu.program(label, fullscreenVert, fragment, { defines: { RAYS: detail.rays } });
    this.#surfelProgram = gpu.program("gi/surfel", cubeFaceVert, surfelFrag);
    this.#radiosityProgram = gpu.program("gi/radiosity", fullscreenVert, radiosityFrag);
    this.#gatherSurfelsProgram = perRay("gi/gather-surfels", gatherSurfelsFrag);
    this.#rayRadianceProgram = perRay("gi/ray-radiance", rayRadianceFrag);
    this.#rayDirectProgram = perRay("gi/ray-direct", rayDirectFrag);
    this.#gatherRaysProgram = perRay("gi/gather-rays", gatherRaysFrag);
    this.#light = gpu.uniformBlock(this.#radiosityProgram, "Light");
    const [columns, rows, planes] = detail.probes;
    const { min, max } = scene.model.bounds;
    this.#block = gpu.uniformBlock(this.#rayRadianceProgram, "Volume");
    this.#block.update({
      corner: min,
      // A floor without walls is a room, too.
      extent: min.map((low, axis) => Math.max((max[axis] ?? low) - low, 0.01)),
      columns,
      rows,
      planes,
      testsVisibility: detail.testsVisibility ? 1 : 0,
    });
    const texel = floats(gpu, 4);
    const surfels = { width: detail.surfels * FACES.length, height: detail.surfels };
    this.#surfels = gpu.renderTarget({
      label: "gi/surfels",
      ...surfels,
      color: [texel, texel],
      depth: "buffer",
      filter: "nearest",
    });
    const single = { width: 1, height: 1, color: [texel], filter: "nearest" } as const;
    this.#support = detail.testsVisibility
      ? null
      : {
          program: gpu.program("gi/support-radiosity", fullscreenVert, supportFrag),
          target: gpu.renderTarget({ label: "gi/support-radiosity", ...single }),
        };
    const radiance = { color: ["RGBA16F"], filter: "nearest" } as const;
    this.#radiosity = gpu.renderTarget({ label: "gi/radiosity", ...surfels, ...radiance });
    const tiles = { width: columns * planes, height: rows };
    const rays = { width: tiles.width * detail.rays, height: tiles.height * detail.rays };
    this.#rayRadiance = gpu.renderTarget({ label: "gi/ray-radiance", ...rays, ...radiance });
    const harmonics = {
      width: tiles.width * SH_TEXELS,
      height: tiles.height,
      color: [texel, texel, texel],
      filter: "nearest",
    } as const;
    this.#firstBounce = gpu.renderTarget({ label: "gi/first-bounce", ...harmonics });
    const bounces = (label: string) =>
      gpu.renderTarget({ label: `gi/bounces/${label}`, ...harmonics });
    this.#bounces = [bounces("a"), bounces("b"), bounces("c")];
    this.#convolution = new IrradianceConvolution(gpu, screen, this.#block, tiles, texel);
  }

  /** Uploaded on first use: their albedo waits for a program. */
  get #probes(): ProbeTextures {
    if (this.#uploaded) return this.#uploaded;
    const { collision, model, surfaces } = this.#scene;
    const rays = traceProbes(collision, model, this.#detail);
    this.#uploaded = this.#gpu.share(rays, () =>
      uploadProbeRays(this.#gpu, rays, this.#detail, surfaces),
    );
    return this.#uploaded;
  }

  /**
   * Indirect light for each candela of the flame's.
   *
   * @param light members of the block of `lib/flame-light.glsl`, of a flame at its capture origin
   */
  render(casters: ShadowCasters, light: CaptureLight): IrradianceVolume {
    this.#update = null;
    if (!this.#isExact || JSON.stringify(light) !== this.#lastLight) {
      this.#gpu.clear(this.#surfels, [0, 0, 0, 0]);
      for (const face of FACES.keys()) this.#capture(casters, light.position, face);
      this.#renderBounces(light);
    }
    return this.#volume;
  }

  /** Amortised update for a moving light: one face of the surfel cube, or all further passes, in each frame. */
  updateIncrementally(casters: ShadowCasters, light: CaptureLight): IrradianceVolume {
    if (this.#lastLight === "") {
      this.render(casters, light);
      this.#isExact = false; // the casters may be of a lower level of detail
      return this.#volume;
    }
    if (!this.#update) {
      if (this.#pause-- > 0 || JSON.stringify(light) === this.#lastLight) return this.#volume;
      this.#update = { light, faces: 0 };
      this.#gpu.clear(this.#surfels, [0, 0, 0, 0]);
    }
    if (this.#update.faces < FACES.length) {
      this.#capture(casters, this.#update.light.position, this.#update.faces++);
    } else {
      this.#updateBounces(this.#update.light);
      this.#update = null;
      this.#pause = SCHEDULE.indirect.restFrames;
    }
    return this.#volume;
  }

  get #volume(): IrradianceVolume {
    return {
      block: this.#block,
      textures: { uIrradiance: this.#convolution.irradiance, ...this.#probes.volume },
      radiosity: this.#radiosity.color,
      support: this.#support?.target.color ?? null,
    };
  }

  #capture(casters: ShadowCasters, captureOrigin: Vec3, face: number): void {
    const size = this.#detail.surfels;
    const clipFromWorld = clipFromFace(face, captureOrigin, mat4.create()) as Float32Array;
    casters.drawWithAlbedo(face, captureOrigin, {
      program: this.#surfelProgram,
      target: this.#surfels,
      viewport: [face * size, 0, size, size],
      uniforms: { uClipFromWorld: clipFromWorld, uCaptureOrigin: captureOrigin },
      depth: "test-and-write",
      cull: "none",
    });
  }

  #renderBounces(light: CaptureLight): void {
    this.#lastLight = JSON.stringify(light);
    this.#isExact = true;
    this.#renderFirstBounce(light);
    this.#convolution.render(this.#firstBounce);
    let [before, previous, last] = [this.#firstBounce, this.#firstBounce, this.#firstBounce];
    for (let bounce = 1; bounce < this.#detail.bounces; bounce++) {
      if (bounce > 1) this.#convolution.render(last);
      [before, previous, last] = [previous, last, this.#bounces[bounce % 3]!];
      this.#renderNextBounce(last);
    }
    this.#convolution.renderExtrapolated(before, previous, last);
  }

  /** One bounce of the previous irradiance stands for all further bounces. */
  #updateBounces(light: CaptureLight): void {
    this.#lastLight = JSON.stringify(light);
    this.#isExact = false;
    this.#renderFirstBounce(light);
    const [, bounces] = this.#bounces;
    this.#renderNextBounce(bounces);
    this.#convolution.render(bounces);
  }

  #renderFirstBounce(light: CaptureLight): void {
    this.#light.update(light);
    const [uSurfelAlbedo, uSurfelNormalDistance] = this.#surfels.colors;
    if (!uSurfelAlbedo || !uSurfelNormalDistance) {
      throw new Error("Surfels take two textures: albedo, and normal with distance.");
    }
    const { uProbePositions } = this.#probes.volume;
    const pass = { vertexArray: this.#screen, blocks: { Light: this.#light } };
    const fromSurfels = { ...pass, textures: { uSurfelAlbedo, uSurfelNormalDistance } };
    this.#gpu.draw({ ...fromSurfels, program: this.#radiosityProgram, target: this.#radiosity });
    if (this.#support) this.#gpu.draw({ ...fromSurfels, ...this.#support });
    this.#gpu.draw({
      ...pass,
      program: this.#gatherSurfelsProgram,
      target: this.#bounces[0],
      textures: {
        uSurfelNormalDistance,
        uRadiosity: this.#radiosity.color,
        uRayHits: this.#probes.rays.uRayHits,
        uProbePositions,
      },
    });
    this.#gpu.draw({
      ...pass,
      program: this.#rayDirectProgram,
      target: this.#rayRadiance,
      textures: { uSurfelNormalDistance, uProbePositions, ...this.#probes.rays },
    });
    this.#gatherRays(this.#bounces[0], this.#firstBounce);
  }

  #renderNextBounce(target: RenderTarget): void {
    this.#gpu.draw({
      program: this.#rayRadianceProgram,
      target: this.#rayRadiance,
      vertexArray: this.#screen,
      textures: {
        uIrradiance: this.#convolution.irradiance,
        ...this.#probes.volume,
        ...this.#probes.rays,
      },
      blocks: { Volume: this.#block },
    });
    this.#gatherRays(this.#firstBounce, target);
  }

  /** The probes' radiance so far, plus that along their rays. */
  #gatherRays(radiance: RenderTarget, target: RenderTarget): void {
    this.#gpu.draw({
      program: this.#gatherRaysProgram,
      target,
      vertexArray: this.#screen,
      textures: { ...harmonicsOf(radiance), uRayRadiance: this.#rayRadiance.color },
    });
  }
}
