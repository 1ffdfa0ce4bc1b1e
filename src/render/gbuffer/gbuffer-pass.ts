import gbufferFrag from "../../../shaders/gbuffer/gbuffer.frag";
import reducedFrag from "../../../shaders/gbuffer/gbuffer-reduced.frag";
import reducedVert from "../../../shaders/gbuffer/gbuffer-reduced.vert";
import meshVert from "../../../shaders/mesh/mesh.vert";
import type { Box, Draw, Gpu, Program, RenderTarget, Texture, UniformBlock } from "../../gl/gpu.js";
import type { Bounds, Vec3 } from "../../world/geometry.js";
import type { Steps } from "../../world/steps.js";
import { frustumTest } from "../camera.js";
import type { FrameInput, ModelInstance, Size } from "../frame-input.js";
import type { Mesh } from "../mesh/mesh.js";
import type { MeshLods } from "../mesh/mesh-lods.js";
import { visibleRuns } from "../mesh/visible-runs.js";
import { type GBufferSamples, UpsampleGuidePass } from "../opaque/upsample-guide-pass.js";
import { SCHEDULE } from "../schedule.js";
import { bandOf, clipOfBox } from "../screen-bounds.js";
import { AlbedoCache, isBaked } from "./albedo-cache.js";
import type { FullGBuffer, GBuffer } from "./gbuffer.js";
import { reprojectionSource } from "./reprojection.js";
import { SampleJitter } from "./sample-jitter.js";

const NOTHING = [0, 0, 0, 0] as const;

/** Samples of the G-buffer in motion along each edge of a pixel. */
const REDUCED_SAMPLES = 0.5;

/** Codes of `shaders/lib/gbuffer.glsl`. */
const MATERIAL = { glass: 5 / 7, wax: 1 } as const;

/** Sampling of material textures for the reduced G-buffer. */
const REDUCED_SAMPLING: NonNullable<Draw["sampling"]> = {
  uAlbedo: "level",
  uGamma2Albedo: "level",
  uNormal: "texel",
  uOcclusionRoughness: "texel",
};

interface Pass {
  readonly target: RenderTarget;
  readonly isReduced: boolean;
  /** The mesh's cached albedo, if it is drawn with it. */
  readonly cached: Texture | null;
  readonly isVisible: (box: Bounds) => boolean;
  readonly scissor: Box | undefined;
}

/**
 * Fills the G-buffer: at rest supersampled, and kept until the camera, a model or the light moves;
 * in motion at half the resolution, every other frame by reprojection of the one before.
 */
export class GBufferPass {
  readonly #gpu: Gpu;
  readonly #frame: UniformBlock;
  /** Of the reduced G-buffer, but for what is held: the flame before it is composited without a history. */
  readonly #jittered: UniformBlock;
  readonly #guide: UpsampleGuidePass;
  readonly #full: FullGBuffer;
  readonly #lods: MeshLods;
  readonly #albedos: AlbedoCache;
  /** Programs that were drawn with, whether these are all of the reduced G-buffer, and frames that have added none. */
  readonly #rehearsed = new Set<Program>();
  #isReducedReady = false;
  #rehearsedBefore = 0; // before this frame
  #quietFrames = 0;
  #targets: Partial<Record<"reduced" | "full", RenderTarget>> = {};
  /** Depth at the canvas's size, of a reduced G-buffer. */
  #reducedFrameDepth: Texture | null = null;
  #reducedKey = "";
  #fullKey = "";
  readonly #jitter = new SampleJitter();
  /** Progressive refinement: the full G-buffer in progress. */
  #refinement: { readonly key: string; readonly steps: Steps } | null = null;
  #wasReduced = false;
  #shadingOrigin: Vec3 = [0, 0, 0];

  /** @param jittered another block `Frame` */
  constructor(
    gpu: Gpu,
    frame: UniformBlock,
    jittered: UniformBlock,
    lods: MeshLods,
    full: FullGBuffer,
  ) {
    this.#gpu = gpu;
    this.#full = full;
    this.#frame = frame;
    this.#jittered = jittered;
    this.#lods = lods;
    this.#albedos = new AlbedoCache(gpu);
    this.#guide = new UpsampleGuidePass(gpu, full.samples);
  }

  resize(size: Size): void {
    for (const old of [...Object.values(this.#targets), this.#reducedFrameDepth]) old?.dispose();
    this.#targets = {};
    this.#reducedFrameDepth = null;
    this.#reducedKey = "";
    this.#fullKey = "";
    this.#jitter.reset();
    this.#refinement = null;
    // The first frame of another size is reduced, too: a full one would take as long as ten.
    this.#wasReduced = this.#isReducedReady;
    this.#guide.resize(size);
  }

  /** Made when it is first needed: an image that never moves, or never rests, needs one of the two. */
  #targetOf(kind: "reduced" | "full"): RenderTarget {
    const { width, height } = this.#guide.resolved;
    const samples = kind === "full" ? this.#full.samples : REDUCED_SAMPLES;
    this.#targets[kind] ??= this.#gpu.renderTarget({
      label: `gbuffer/${kind}`,
      width: Math.ceil(width * samples),
      height: Math.ceil(height * samples),
      color: ["RGBA8", "RGBA8"],
      depth: "texture",
      filter: kind === "reduced" ? "linear" : "nearest",
    });
    return this.#targets[kind];
  }

  /**
   * @param lightingSize of the full lighting, which the guide leads to
   * @param origin where normal-map shading takes the light to be, metres
   */
  *render(frame: FrameInput, lightingSize: Size, origin: Vec3): Steps<GBuffer> {
    this.#shadingOrigin = origin;
    const { isMoving, canDefer, features } = frame.settings;
    const { size } = this.#rehearsed;
    this.#quietFrames =
      this.#wasReduced && size === this.#rehearsedBefore ? this.#quietFrames + 1 : 0;
    this.#rehearsedBefore = size;
    const key = JSON.stringify([
      [...frame.clipFromWorld],
      features.normalMaps && origin,
      features.translucency,
      lightingSize,
      frame.instances.map(({ placement }) => placement),
    ]);
    const { surfaces, guide } = SCHEDULE.refinement;
    if (isMoving) this.#refinement = null;
    else if (key !== this.#fullKey) {
      if (!this.#wasReduced || !canDefer) {
        this.#refinement = null;
        const { width, height } = this.#guide.resolved;
        const bands = Math.ceil((width * height) / this.#full.pixelsPerStep) || 1;
        const parts = Math.ceil((bands * guide) / surfaces);
        yield* this.#fill(frame, key, lightingSize, bands, parts);
      } else if (this.#reducedKey !== "") {
        // The reduced G-buffer goes on being shown until the full one is complete.
        if (this.#refinement?.key !== key) {
          const steps = this.#fill(frame, key, lightingSize, surfaces, guide);
          this.#refinement = { key, steps };
        }
        if (this.#refinement.steps.next().done) this.#refinement = null;
      }
    }
    this.#wasReduced = isMoving || key !== this.#fullKey;
    if (this.#wasReduced) return yield* this.#renderReduced(frame, key);
    this.#jitter.reset();
    yield;
    if (canDefer) this.#prepareReduced(frame);
    return {
      kind: "full",
      ...samplesOf(this.#targetOf("full")),
      albedo: this.#guide.resolved.color,
      frameDepth: this.#guide.resolved.depth!,
      representative: this.#guide.representative,
      key: `full ${key}`,
      history: null,
      sampleOffset: [0, 0],
    };
  }

  *#renderReduced(frame: FrameInput, key: string): Steps<GBuffer> {
    const target = this.#targetOf("reduced");
    const { clipFromWorld, instances, settings } = frame;
    const current = reprojectionSource(instances, clipFromWorld, settings.features);
    const history = this.#jitter.historyOf(current);
    const isReprojected = this.#jitter.mayReproject(history) && settings.isMoving;
    if (!isReprojected && key !== this.#reducedKey) {
      this.#reducedKey = "";
      this.#gpu.clear(target, NOTHING);
      this.#jittered.update({
        clipFromWorld: this.#jitter.next(clipFromWorld, target),
        normalMaps: settings.features.normalMaps ? 1 : 0,
      });
      if (this.#quietFrames >= SCHEDULE.quietFrames) this.#updateIncrementally(instances);
      yield* this.#drawModels(target, frame, true);
      this.#reducedKey = key;
      this.#jitter.drawn(current);
    }
    this.#reducedFrameDepth ??= this.#gpu.texture({
      label: "gbuffer/reduced/frame depth",
      format: "DEPTH_COMPONENT24",
      source: { width: this.#guide.resolved.width, height: this.#guide.resolved.height },
      filter: "nearest",
    });
    return {
      kind: isReprojected ? "reprojected" : "reduced",
      ...samplesOf(target),
      frameDepth: this.#reducedFrameDepth,
      representative: null,
      key: `reduced ${this.#reducedKey}`,
      history,
      sampleOffset: this.#jitter.offset,
    };
  }

  /** The full G-buffer in bands, a step each, of which the last ones are resolved. */
  *#fill(frame: FrameInput, key: string, lightingSize: Size, bands: number, parts: number): Steps {
    this.#fullKey = ""; // the targets hold parts of two images
    const target = this.#targetOf("full");
    for (let band = 0; band < bands; band++) {
      const scissor = bands > 1 ? bandOf(target, band, bands) : undefined;
      this.#gpu.clear(target, NOTHING, scissor);
      yield* this.#drawModels(target, frame, false, scissor);
      yield;
    }
    this.#guide.chooseRepresentatives(samplesOf(target), lightingSize);
    for (let part = 0; part < parts; part++) {
      if (part > 0) yield;
      const scissor = parts > 1 ? bandOf(this.#guide.resolved, part, parts) : undefined;
      this.#guide.resolve(samplesOf(target), lightingSize, scissor);
    }
    this.#fullKey = key;
  }

  /** In steps that end where many drivers compile: at a program's first draw. */
  *#drawModels(target: RenderTarget, frame: FrameInput, isReduced: boolean, scissor?: Box): Steps {
    const { clipFromWorld } = frame;
    const isVisible = frustumTest(
      scissor ? clipOfBox(scissor, target, clipFromWorld) : clipFromWorld,
    );
    for (const instance of frame.instances) {
      for (const mesh of isReduced ? this.#lods.merged(instance.meshes) : instance.meshes) {
        const drawn = this.#rehearsed.size;
        const cached = isReduced ? this.#cachedAlbedoOf(mesh) : null;
        this.#drawMesh(mesh, instance, frame, { target, isReduced, cached, isVisible, scissor });
        if (this.#rehearsed.size > drawn) yield;
      }
    }
  }

  /** At rest: what the first frame in motion needs is made, and its programs are drawn with, one in each frame. */
  #prepareReduced(frame: FrameInput): void {
    if (this.#isReducedReady || !this.#updateIncrementally(frame.instances)) return;
    for (const instance of frame.instances) {
      for (const mesh of this.#lods.merged(instance.meshes)) {
        const cached = this.#albedos.of(mesh);
        const program = this.#programFor(true, cached !== null, mesh);
        if (this.#rehearsed.has(program)) continue;
        const target = this.#targetOf("reduced");
        this.#drawMesh(mesh, instance, frame, { ...REHEARSAL, target, cached });
        return;
      }
    }
    this.#isReducedReady = true;
  }

  /** Goes on with what only frames in motion need. True when all of it is made. */
  #updateIncrementally(instances: readonly ModelInstance[]): boolean {
    this.#albedos.updateIncrementally(instances.flatMap(({ meshes }) => meshes));
    const isMerged = instances.every(({ meshes }) => this.#lods.mergeIncrementally(meshes));
    return isMerged && this.#albedos.isComplete;
  }

  /** `discard` costs all that is drawn later its early depth test, so that only cut-out surfaces have it. */
  #programFor(isReduced: boolean, isCached: boolean, mesh: Mesh): Program {
    const ALPHA_TESTED = mesh.uniforms.uSurface[3] > 0 ? 1 : 0;
    const BAKED = isBaked(mesh) ? 1 : 0;
    const UNTEXTURED = BAKED && mesh.isUntextured ? 1 : 0;
    const detail = isCached ? { BAKED, UNTEXTURED } : { REDUCED: isReduced ? 1 : 0 };
    const defines = { ALPHA_TESTED, ...detail };
    return isCached
      ? this.#gpu.program("gbuffer/gbuffer-reduced", reducedVert, reducedFrag, { defines })
      : this.#gpu.program("gbuffer/gbuffer", meshVert, gbufferFrag, { defines });
  }

  /** In motion one frame in a few draws with a new program; until then a mesh is drawn without its cached albedo. */
  #cachedAlbedoOf(mesh: Mesh): Texture | null {
    const isQuiet = this.#quietFrames >= SCHEDULE.quietFrames;
    const mayCompile = isQuiet && this.#rehearsed.size === this.#rehearsedBefore;
    const mayUse = mayCompile || this.#rehearsed.has(this.#programFor(true, true, mesh));
    return mayUse ? this.#albedos.of(mesh) : null;
  }

  #drawMesh(
    mesh: Mesh,
    { placement, isHeld }: ModelInstance,
    frame: FrameInput,
    { target, isReduced, cached, isVisible, scissor }: Pass,
  ): void {
    const { vertexArray } = mesh;
    const { translucency } = frame.settings.features;
    const draw: Draw = {
      program: this.#programFor(isReduced, cached !== null, mesh),
      target,
      vertexArray,
      textures: cached ? { ...mesh.textures, uGamma2Albedo: cached } : mesh.textures,
      sampling: isReduced ? REDUCED_SAMPLING : {},
      uniforms: {
        ...mesh.uniforms,
        uPlacement: placement,
        uMaterial: mesh.isPane ? MATERIAL.glass : mesh.isWax && translucency ? MATERIAL.wax : 0,
        uCaptureOrigin: this.#shadingOrigin,
        uIsHeld: isHeld ? 1 : 0,
        ...(cached && {
          uBaseColor: gamma2(mesh.uniforms.uBaseColor),
          uRotation: [Math.cos(placement[3]), Math.sin(placement[3])],
        }),
      },
      blocks: { Frame: isReduced && !isHeld ? this.#jittered : this.#frame },
      depth: "test-and-write",
      scissor,
      cull: mesh.isDoubleSided ? "none" : "back",
    };
    for (const { first, count } of visibleRuns(mesh, placement, isVisible)) {
      this.#gpu.draw({ ...draw, first, count });
      this.#rehearsed.add(draw.program);
    }
  }
}

/** A draw that only has the driver compile: of one pixel. */
const REHEARSAL = { isReduced: true, isVisible: () => true, scissor: [0, 0, 1, 1] } as const;

function samplesOf({ colors: [albedo, surface], depth }: RenderTarget): GBufferSamples {
  return { albedo: albedo!, surface: surface!, depth: depth! };
}

function gamma2([red, green, blue, opacity]: Mesh["uniforms"]["uBaseColor"]) {
  return [Math.sqrt(red), Math.sqrt(green), Math.sqrt(blue), opacity];
}
