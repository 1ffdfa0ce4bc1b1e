import type { mat4 } from "gl-matrix";
import geometryFrag from "../../../shaders/gbuffer/gbuffer.frag";
import passingFrag from "../../../shaders/gbuffer/gbuffer-reduced.frag";
import passingVert from "../../../shaders/gbuffer/gbuffer-reduced.vert";
import surfaceVert from "../../../shaders/mesh/mesh.vert";
import usualFrag from "../../../shaders/opaque/representative-sample.frag";
import guideFrag from "../../../shaders/opaque/upsample-guide.frag";
import fullscreenVert from "../../../shaders/post/fullscreen.vert";
import type { Box, Draw, Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { RenderTarget } from "../../gl/render-target.js";
import type { Texture, TextureFormat } from "../../gl/texture.js";
import type { UniformBlock } from "../../gl/uniform-block.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import type { Features } from "../../settings.js";
import type { Bounds, Vec3 } from "../../world/geometry.js";
import { sightOf } from "../camera.js";
import { runsOf } from "../mesh/clusters.js";
import type { Surface } from "../mesh/mesh.js";
import type { Drawable, MeshLods } from "../mesh/mesh-lods.js";
import { AlbedoCache, isBaked } from "./albedo-cache.js";
import {
  AT_ORIGIN,
  historyOf,
  type Kept,
  type Paint,
  type Placed,
  reprojectionBetween,
} from "./gbuffer.js";
import { bandOf, clipOfBand } from "./screen-bands.js";

const NOTHING = [0, 0, 0, 0] as const;
/** Relief follows the flame in steps of this, metres. */
const RELIEF_STEP = 0.05;

/** Pictures over which a fine one is spread: its surfaces, by stripes, and then its guide. */
const STRIPES = { surfaces: 12, guide: 4 } as const;

/** Samples along each edge of a pixel: what is on its way over the retina is not seen sharply. */
const SAMPLES = { moving: 0.5, resting: 2 } as const;

/** How coarse surfaces read their textures. */
const COARSE: NonNullable<Draw["sampling"]> = {
  uAlbedo: "level",
  uGamma2Albedo: "level",
  uNormal: "texel",
  uOcclusionRoughness: "texel",
};

/** All that the paint depends on, beside the surfaces. */
export interface Sight {
  readonly clip: mat4;
  readonly vantage: Vec3;
  readonly features: Features;
  /** Whether the next picture will be another one anyway. */
  readonly isMoving: boolean;
  /** Whether the next picture comes soon: a fine one after coarse ones may take the time of many. */
  readonly isPatient: boolean;
  /** Texels of the light that the guide leads to. */
  readonly lightSize: { readonly width: number; readonly height: number };
}

/** What is to be painted. */
interface Scene {
  readonly placed: readonly Placed[];
  /** Of the flame, in steps. */
  readonly vantage: readonly number[];
  readonly frame: UniformBlock;
  readonly sight: Sight;
}

/** Where and how. */
interface Painting {
  readonly target: RenderTarget;
  readonly isCoarse: boolean;
  /** Of a box of triangles, whether it may show there. */
  readonly isSeen: (box: Bounds) => boolean;
  readonly scissor: Box | undefined;
}

/** The room and the candle as surfaces, drawn anew only when they, the eye or the flame have moved. */
export class GBufferPass {
  readonly #gpu: Gpu;
  readonly #screen: VertexArray;
  readonly #chooseUsual: Program;
  readonly #guide: Program;
  /** By what they are defined for. */
  readonly #programs = new Map<string, Program>();
  #isMotionPrepared = false;
  readonly #coarse: MeshLods;
  readonly #roots: AlbedoCache;
  #moving: RenderTarget | null = null;
  #resting: RenderTarget | null = null;
  #painted: RenderTarget | null = null;
  /** Which of the samples of who rests light is worked out at. */
  #usual: RenderTarget | null = null;
  /** How far away the fire's surroundings are while the eye moves. */
  #movingDepth: Texture | null = null;
  /** What was painted coarsely, and what finely. */
  #coarseKnown = "";
  #fineKnown = "";
  /** What was painted coarsely in the picture before. */
  #kept: Kept | null = null;
  /** What is being painted finely, by how many stripes it is done; null between such pictures. */
  #begun: { readonly known: string; stripes: number } | null = null;
  #wasCoarse = false;

  constructor(gpu: Gpu, screen: VertexArray, coarse: MeshLods) {
    this.#gpu = gpu;
    this.#screen = screen;
    this.#coarse = coarse;
    this.#roots = new AlbedoCache(gpu, screen);
    this.#chooseUsual = gpu.program("opaque/representative-sample", fullscreenVert, usualFrag);
    this.#guide = gpu.program("opaque/upsample-guide", fullscreenVert, guideFrag, {
      defines: { SAMPLES: SAMPLES.resting },
    });
  }

  resize(width: number, height: number): void {
    const textures = [this.#moving, this.#resting, this.#painted, this.#usual, this.#movingDepth];
    for (const old of textures) old?.dispose();
    this.#moving = null;
    this.#resting = null;
    this.#usual = null;
    this.#movingDepth = null;
    this.#coarseKnown = "";
    this.#fineKnown = "";
    this.#kept = null;
    this.#begun = null;
    this.#wasCoarse = false;
    this.#painted = this.#target("painted", { width, height }, ["RGBA8"]);
  }

  #target(
    label: string,
    size: { readonly width: number; readonly height: number },
    color: readonly TextureFormat[],
  ): RenderTarget {
    // What is coarse is mixed where it is enlarged.
    const filter = label === "surfaces/moving" ? "linear" : "nearest";
    return this.#gpu.renderTarget({ label, ...size, color, depth: "texture", filter });
  }

  /** Made when it is first needed: a picture that never moves, or never rests, needs only one. */
  #surfaces(isMoving: boolean): RenderTarget {
    if (!this.#painted) throw new Error("Surfaces have no size yet.");
    const name = isMoving ? "moving" : "resting";
    const size = {
      width: Math.ceil(this.#painted.width * SAMPLES[name]),
      height: Math.ceil(this.#painted.height * SAMPLES[name]),
    };
    const make = () => this.#target(`surfaces/${name}`, size, ["RGBA8", "RGBA8"]);
    if (isMoving) this.#moving ??= make();
    else this.#resting ??= make();
    return (isMoving ? this.#moving : this.#resting)!;
  }

  render(placed: readonly Placed[], frame: UniformBlock, sight: Sight): Paint {
    const { clip, features, lightSize, isMoving } = sight;
    const vantage = sight.vantage.map((x) => Math.round(x / RELIEF_STEP) * RELIEF_STEP);
    const known = JSON.stringify([
      [...clip],
      features.normalMaps && vantage,
      features.translucency,
      lightSize,
      placed.map(({ place }) => place),
    ]);
    const scene = { placed, vantage, frame, sight };
    if (isMoving) this.#begun = null;
    else if (known !== this.#fineKnown) {
      // Who has just stopped goes on to see what a moving eye does, until the fine picture is there.
      if (this.#wasCoarse && sight.isPatient) this.#proceed(scene, known);
      else this.#paintFinely(scene, known);
    }
    this.#wasCoarse = isMoving || known !== this.#fineKnown;
    if (this.#wasCoarse) return this.#paintCoarsely(scene, known);
    this.#kept = null;
    if (sight.isPatient) this.#prepareMotion(scene);
    const [surfaces, depth] = this.#partsOf(this.#surfaces(false));
    const { color: painted, depth: frameDepth } = this.#painted!;
    if (!frameDepth) throw new Error("Paint has a depth.");
    const usual = this.#usual?.color ?? null;
    const paint = { painted, frameDepth, surfaces, depth, usual, known: `fine ${known}` };
    return { ...paint, kind: "fine", since: null };
  }

  #partsOf({ colors: [, surfaces], depth }: RenderTarget): [Texture, Texture] {
    if (!surfaces || !depth) throw new Error("Surfaces have three textures.");
    return [surfaces, depth];
  }

  #paintCoarsely(scene: Scene, known: string): Paint {
    const target = this.#surfaces(true);
    const [surfaces, depth] = this.#partsOf(target);
    const { clip, features, isMoving } = scene.sight;
    const now = historyOf(scene.placed, clip, features);
    const before = this.#kept;
    this.#kept = null;
    const since = before && isMoving ? reprojectionBetween(now, before) : null;
    if (!since && known !== this.#coarseKnown) {
      this.#coarseKnown = known;
      this.#gpu.clear(target, NOTHING);
      this.#prepare(scene.placed);
      this.#drawSurfaces(target, scene, true);
      this.#kept = now;
    }
    this.#movingDepth ??= this.#gpu.texture({
      label: "surfaces/moving/fire",
      format: "DEPTH_COMPONENT24",
      source: { width: this.#painted!.width, height: this.#painted!.height },
      filter: "nearest",
    });
    const [painted, frameDepth] = [target.color, this.#movingDepth];
    const seen = { painted, frameDepth, surfaces, depth, usual: null };
    const paint = { ...seen, known: `coarse ${this.#coarseKnown}` };
    return { ...paint, kind: since ? "kept" : "coarse", since };
  }

  #paintFinely(scene: Scene, known: string): void {
    this.#begun = null;
    this.#fineKnown = known;
    this.#gpu.clear(this.#surfaces(false), NOTHING);
    this.#drawSurfaces(this.#surfaces(false), scene, false);
    this.#gpu.clear(this.#painted!, NOTHING);
    this.#drawUsual(scene.sight);
    this.#drawGuide(scene.sight);
  }

  /** The same, a stripe at a time. */
  #proceed(scene: Scene, known: string): void {
    if (this.#begun?.known !== known) this.#begun = { known, stripes: 0 };
    this.#fineKnown = ""; // half of another picture
    const stripe = this.#begun.stripes++;
    if (stripe < STRIPES.surfaces) {
      const target = this.#surfaces(false);
      const band = bandOf(target, stripe, STRIPES.surfaces);
      this.#gpu.clear(target, NOTHING, band);
      this.#drawSurfaces(target, scene, false, band);
      return;
    }
    if (stripe === STRIPES.surfaces) this.#drawUsual(scene.sight);
    const band = bandOf(this.#painted!, stripe - STRIPES.surfaces, STRIPES.guide);
    this.#gpu.clear(this.#painted!, NOTHING, band);
    this.#drawGuide(scene.sight, band);
    if (this.#begun.stripes < STRIPES.surfaces + STRIPES.guide) return;
    this.#begun = null;
    this.#fineKnown = known;
  }

  #drawSurfaces(target: RenderTarget, scene: Scene, isCoarse: boolean, band?: Box): void {
    const { clip } = scene.sight;
    const isSeen = sightOf(band ? clipOfBand(band, target, clip) : clip);
    for (const model of scene.placed) {
      for (const surface of isCoarse ? this.#coarse.merged(model.surfaces) : model.surfaces) {
        this.#draw(surface, model, scene, { target, isCoarse, isSeen, scissor: band });
      }
    }
  }

  /** Gets ready, while the eye rests, for its first move: programs are compiled and drawn with once. */
  #prepareMotion(scene: Scene): void {
    this.#prepare(scene.placed);
    if (this.#isMotionPrepared || !this.#roots.isComplete) return;
    this.#isMotionPrepared = true;
    const how = { target: this.#surfaces(true), isCoarse: true, isSeen: () => true } as const;
    const drawn = new Set<Program>();
    for (const model of scene.placed) {
      for (const surface of this.#coarse.merged(model.surfaces)) {
        const program = this.#programFor(true, this.#roots.of(surface) !== null, surface);
        if (drawn.has(program)) continue;
        drawn.add(program);
        this.#draw(surface, model, scene, { ...how, scissor: [0, 0, 1, 1] });
      }
    }
  }

  /** Goes on with what is only needed of pictures that follow each other. */
  #prepare(placed: readonly Placed[]): void {
    this.#roots.proceed(placed.flatMap(({ surfaces }) => surfaces));
    this.#coarse.proceed(everySurface(placed));
  }

  /** Where light is to be worked out. */
  #drawUsual({ lightSize }: Sight): void {
    const [uGBufferSurface, uDepth] = this.#partsOf(this.#surfaces(false));
    const how = { label: "surfaces/usual", color: ["R8"], filter: "nearest" } as const;
    this.#usual ??= this.#gpu.renderTarget({ ...how, ...lightSize });
    this.#gpu.draw({
      program: this.#chooseUsual,
      target: this.#usual,
      vertexArray: this.#screen,
      textures: { uGBufferSurface, uDepth },
      uniforms: { uLightingSize: [lightSize.width, lightSize.height] },
    });
  }

  /** Which light each pixel is to take; one that moves takes what is around it. */
  #drawGuide({ lightSize }: Sight, scissor?: Box): void {
    const resting = this.#surfaces(false);
    const [surfaces, depth] = this.#partsOf(resting);
    this.#gpu.draw({
      program: this.#guide,
      target: this.#painted!,
      vertexArray: this.#screen,
      textures: {
        uAlbedo: resting.color,
        uGBufferSurface: surfaces,
        uDepth: depth,
        uRepresentative: this.#usual!.color,
      },
      uniforms: { uLightingSize: [lightSize.width, lightSize.height] },
      depth: "test-and-write",
      scissor,
    });
  }

  /** Whoever may be cut out costs all that is drawn later its early test of depth. */
  #programFor(isMoving: boolean, hasRoot: boolean, surface: Surface): Program {
    const ALPHA_TESTED = surface.parameters[3] > 0 ? 1 : 0;
    const BAKED = isBaked(surface) ? 1 : 0;
    const UNTEXTURED = BAKED && surface.isPlain ? 1 : 0;
    const detail = hasRoot ? { BAKED, UNTEXTURED } : { MOVING: isMoving ? 1 : 0 };
    const defines = { ALPHA_TESTED, ...detail };
    const key = JSON.stringify(defines);
    const program =
      this.#programs.get(key) ??
      (hasRoot
        ? this.#gpu.program("gbuffer/gbuffer-reduced", passingVert, passingFrag, { defines })
        : this.#gpu.program("gbuffer/gbuffer", surfaceVert, geometryFrag, { defines }));
    this.#programs.set(key, program);
    return program;
  }

  #draw(
    surface: Surface,
    { place, isHeld = false }: Placed,
    { vantage, frame, sight: { features } }: Scene,
    { target, isCoarse, isSeen, scissor }: Painting,
  ): void {
    // What stands where it was made can be left out where nobody looks.
    const { clusters, vertexArray }: Drawable = isCoarse ? this.#coarse.of(surface) : surface;
    const runs =
      place === AT_ORIGIN
        ? runsOf(clusters, isSeen, false)
        : isSeen(aroundTurned(clusters, place))
          ? [{ first: 0, count: vertexArray.count }]
          : [];
    const root = isCoarse ? this.#roots.of(surface) : null;
    const how: Draw = {
      program: this.#programFor(isCoarse, root !== null, surface),
      target,
      vertexArray,
      textures: root ? { ...surface.textures, uGamma2Albedo: root } : surface.textures,
      sampling: isCoarse ? COARSE : {},
      uniforms: {
        uBaseColor: surface.baseColor,
        uPlacement: place,
        uSurface: surface.parameters,
        uWax: surface.isWax && features.translucency ? 1 : 0,
        uCaptureOrigin: vantage,
        ...(isCoarse && { uIsHeld: isHeld ? 1 : 0 }),
        ...(root && {
          uBaseColor: rootOf(surface.baseColor),
          uRotation: [Math.cos(place[3]), Math.sin(place[3])],
        }),
        ...(!(root && isBaked(surface)) && { uOcclusionStrength: surface.occlusionStrength }),
      },
      blocks: { Frame: frame },
      depth: "test-and-write",
      scissor,
      cull: surface.isDoubleSided ? "none" : "back",
    };
    for (const { first, count } of runs) this.#gpu.draw({ ...how, first, count });
  }
}

/** A box around clusters that stand elsewhere, however they are turned about the vertical. */
function aroundTurned(clusters: readonly Bounds[], [x, y, z]: Placed["place"]): Bounds {
  let [radius, low, high] = [0, 0, 0];
  for (const { min, max } of clusters) {
    const wide = [0, 2].map((axis) => Math.max(Math.abs(min[axis]!), Math.abs(max[axis]!)));
    radius = Math.max(radius, Math.hypot(...wide));
    low = Math.min(low, min[1]);
    high = Math.max(high, max[1]);
  }
  return { min: [x - radius, y + low, z - radius], max: [x + radius, y + high, z + radius] };
}

function rootOf([red, green, blue, opacity]: Surface["baseColor"]): Surface["baseColor"] {
  return [Math.sqrt(red), Math.sqrt(green), Math.sqrt(blue), opacity];
}

function* everySurface(placed: readonly Placed[]): Generator<readonly [Surface, number]> {
  for (const { surfaces, slack } of placed) {
    for (const surface of surfaces) yield [surface, slack];
  }
}
