import displayFrag from "../../../shaders/candle/custom-display.frag";
import surfaceFrag from "../../../shaders/candle/custom-surface.frag";
import surfaceVert from "../../../shaders/mesh/mesh.vert";
import type { Model } from "../../assets/model.js";
import type { Box, Gpu, Program, RenderTarget, UniformBlock } from "../../gl/gpu.js";
import { nextTask } from "../../gl/next-task.js";
import { carriedFlame, emberOverPage, type RootedFlame, TAPER } from "../../light/flame-light.js";
import type { Features } from "../../settings.js";
import type { Bounds } from "../../world/geometry.js";
import type { Wick } from "../../world/standing-candle.js";
import { finish } from "../../world/steps.js";
import type { World } from "../../world/world.js";
import type { FrameSettings } from "../frame-settings.js";
import { type Mesh, plainTextures, surfaceSampling, uploadModel } from "../mesh/mesh.js";
import type { Tier } from "../quality.js";
import { MeshCasters } from "../shadow/shadow-casters.js";
import { ShadowPass, shadowAtlas } from "../shadow/shadow-pass.js";
import { type BurningWick, FlamePass } from "../volumetric/flame-pass.js";
import { wickShape } from "../volumetric/wick-shape.js";
import type { DrawInLight } from "./cached-surfaces.js";
import { boundsWithFlames, frameBox } from "./custom-framing.js";
import { FlameLights, shadowOrigin } from "./flame-lights.js";
import { glareFactor } from "./glare.js";
import { BOUNCE_LIGHT, STUDIO_LIGHT } from "./light-groups.js";
import { LightMeter, MOST_EXPOSURE } from "./light-meter.js";
import { type LoneCamera, LoneRenderer, type SmokePassOf } from "./lone-renderer.js";
import { SummedSurfaces } from "./summed-surfaces.js";

/** Share of the hemisphere that the model itself fills, as seen from its points. */
const BOUNCE = 0.1;
/** Share of the light that a taper alone has from its studio. */
const STUDIO = 0.7;
/** Less than in rooms, to keep the model's own colours. */
const VIBRANCE = 0.4;
/** A flame's stops above the display's white at the largest exposure. */
const FLAME_STOPS = 15.5;
/** Samples of a soft shadow of up to four flames, by tier; of more, each is a smaller part of the light. */
const TAPS = { low: 8, medium: 16, high: 32, ultra: 48 } as const;
/** Texels along an edge of a shadow cube: at the cheapest tier, and of up to four flames or more at others. */
const CUBE = { low: 128, few: 512, many: 256 } as const;
/** `SHADOW_NEAR` of candle/custom-surface.frag, metres. */
const NEAR = 0.004;

const NONE = [0, 0, 0] as const;
const DEPTH_ALONE = { writesColor: false, cull: "back" } as const;

/** GPU objects of one model on a context that others draw on, too. */
function createResources(gpu: Gpu, program: Program, model: Model, flames: number, cube: number) {
  const atlas = shadowAtlas(gpu, cube, flames, NEAR);
  return {
    meshes: uploadModel(gpu, model),
    atlas,
    shadows: Array.from({ length: flames }, (_, i) => new ShadowPass(gpu, atlas, i)),
    frame: gpu.uniformBlock(program, "Frame"),
    flames: gpu.uniformBlock(program, "Flames"),
    /** Of one light alone. */
    alone: gpu.uniformBlock(program, "Flames"),
    flame: new FlamePass(gpu, true),
  };
}

/** Light of a frame. */
interface Illumination {
  readonly flames: UniformBlock;
  /** Radiance of the studio, and of the model around, cd/m². */
  readonly environment: readonly number[];
  readonly bounce: readonly number[];
  /** Whether wax glows. */
  readonly translucency: boolean;
}

/** Material of a mesh in the terms of candle/custom-surface.frag. */
interface Surface {
  readonly mesh: Mesh;
  readonly isClear: boolean;
  /** Whether most of the light passes: it receives no shadows. */
  readonly isTransmissive: boolean;
  readonly uniforms: Readonly<Record<string, number | readonly number[]>>;
}

/** What a frame is drawn by. */
interface View {
  readonly rooted: readonly BurningWick[];
  readonly camera: LoneCamera;
  readonly magnification: number;
  /** Luminance of the model's middle tones, cd/m². */
  readonly key: number;
  readonly exposure: number;
  /** Factor on the studio's light. */
  readonly studio: number;
}

/**
 * A visitor's own candles over the page's background: one to sixteen flames on a model.
 *
 * Where frames follow each other at `low`, the surfaces are the sum of images that are kept, one for each light, as of flames at
 * rest; else they are drawn in each frame.
 */
export class CustomModelRenderer extends LoneRenderer {
  isCatchingUp = false;
  readonly #surfaceProgram: Program;
  readonly #displayProgram: Program;
  readonly #resources: ReturnType<typeof createResources>;
  readonly #release: () => void;
  readonly #wicks: readonly Surface[];
  readonly #opaque: readonly Surface[];
  readonly #clear: readonly Surface[];
  readonly #casters: MeshCasters;
  readonly #boundsWith: (firstWick: number) => Bounds;
  /** Diameter of the first wick that the camera looks at all flames for, metres. */
  #firstWick = Number.NaN;
  #bounds: Bounds;
  readonly #meter: LightMeter;
  readonly #lights: FlameLights;
  /** Of the opaque ones, at `low`. */
  readonly #summed: SummedSurfaces | null;
  /** View and settings of the frame that is drawn. */
  #current: { readonly view: View; readonly features: Features } | null = null;
  /** The last frame, if it was a sum of images. */
  #lastSum: { readonly world: World; readonly settings: FrameSettings } | null = null;
  /** Whether the target's depth is that of the opaque surfaces. */
  #hasDepth = false;

  constructor(gpu: Gpu, model: Model, wicks: readonly Wick[], tier: Tier, smokePass: SmokePassOf) {
    super(gpu, tier, smokePass);
    this.#boundsWith = (wickDiameter) =>
      boundsWithFlames(
        model.bounds,
        wicks.map((wick, i) => (i === 0 ? { ...wick, wickDiameter } : wick)),
      );
    this.#bounds = model.bounds;
    this.#surfaceProgram = this.#programOf({ SHADOW_TAPS: tapsOf(tier, wicks.length) });
    this.#displayProgram = gpu.pass("candle/custom-display", displayFrag);
    const isSummed = tier.name === "low";
    const cube = isSummed ? CUBE.low : wicks.length > 4 ? CUBE.many : CUBE.few;
    plainTextures(gpu); // outlive the model
    const { made, release } = gpu.scoped(() =>
      createResources(gpu, this.#surfaceProgram, model, wicks.length, cube),
    );
    this.#resources = made;
    this.#release = release;
    const wickParts = made.meshes.filter(({ isWick }) => isWick).map(({ part }) => part);
    this.#lights = new FlameLights(wicks.map(({ position }) => wickShape(position, wickParts)));
    const surfaces = made.meshes.map(surfaceOf);
    if (surfaces.some(({ isTransmissive }) => isTransmissive)) this.#programOf({});
    this.#clear = surfaces.filter(({ isClear }) => isClear);
    this.#wicks = surfaces.filter(({ isClear, uniforms }) => !isClear && uniforms.uWick === 1);
    // Wicks stand in their own flames, and clear surfaces transmit light: these cast shadows.
    this.#opaque = surfaces.filter(({ isClear, uniforms }) => !isClear && uniforms.uWick === 0);
    const casters = this.#opaque.map(({ mesh }) => mesh);
    this.#casters = new MeshCasters(gpu, casters);
    const parts = casters.map(({ part }) => part);
    this.#meter = new LightMeter(parts, wicks.length);
    const draw: DrawInLight = (...call) => this.#drawInLight(...call);
    this.#summed = isSummed ? new SummedSurfaces(gpu, wicks.length, draw) : null;
  }

  #programOf(defines: { readonly SHADOW_TAPS?: number }): Program {
    return this.gpu.program("candle/custom-surface", surfaceVert, surfaceFrag, { defines });
  }

  override resize(width: number, height: number): void {
    super.resize(width, height);
    this.#hasDepth = false;
  }

  /** Draws the images of the surfaces that the first frame is a sum of. */
  async prepare(world: World, settings: FrameSettings, isWanted: () => boolean): Promise<void> {
    const summed = this.#summedIn(settings);
    if (!summed) return;
    const view = this.#viewOf(world);
    this.begin(this.#resources.frame, view.camera, view.exposure, settings);
    while (isWanted() && !this.#proceed(summed, view, settings)) {
      await this.gpu.whenIdle();
      await nextTask();
    }
  }

  protected drawFrame(world: World, settings: FrameSettings): void {
    const { frame, flames, flame } = this.#resources;
    const { features } = settings;
    const view = this.#viewOf(world);
    const { rooted, camera, key, exposure, studio } = view;
    const summed = this.#summedIn(settings);
    const behind = this.#hasDepth ? "kept" : "none";
    const drawn = this.begin(frame, camera, exposure, settings, summed ? behind : undefined);
    const { target, clip } = drawn;
    const glare = glareFactor(settings, exposure / MOST_EXPOSURE);
    const ember = emberOverPage(exposure);
    flames.update(this.#lights.members(rooted, clip, features.shadows, glare, ember));
    const light: Illumination = {
      flames,
      environment: scaled(TAPER.color, studio),
      bounce: scaled(TAPER.color, key * BOUNCE),
      translucency: features.translucency,
    };
    this.isCatchingUp = summed !== null && !this.#proceed(summed, view, settings);
    // All at once where none was prepared: frames between would take longer.
    while (summed && !summed.areShown) this.#proceed(summed, view, settings);
    if (!summed && features.candle) this.#drawSurfaces(this.#opaque, target, light);
    if (summed && !this.#hasDepth) {
      this.#casters.drawDepth({ ...DEPTH_ALONE, target, uClipFromWorld: clip as Float32Array });
    }
    this.#hasDepth = summed !== null;
    const test = { isDepthKept: this.#hasDepth };
    if (features.candle) this.#drawSurfaces(this.#wicks, target, light, test);
    const { flameSteps } = this.tier.physical;
    for (const one of features.volume ? rooted : []) flame.render(target, frame, one, flameSteps);
    if (features.smoke) this.drawSmoke(world, drawn, frame, light.environment, rooted);
    if (features.candle) this.#drawSurfaces(this.#clear, target, light);
    this.#display(view, summed);
    this.#lastSum = summed && { world, settings };
  }

  #display(view: View, summed: SummedSurfaces | null): void {
    const { rooted, magnification, key, exposure, studio } = view;
    const { frame, flames } = this.#resources;
    const uniforms = {
      uVibrance: VIBRANCE,
      uMagnification: magnification,
      uHighlights: FLAME_STOPS / (FLAME_STOPS + Math.log2(exposure / MOST_EXPOSURE)),
      ...(summed && {
        uScales: summed.scales(rooted, {
          studio,
          bounce: key * BOUNCE,
          ember: emberOverPage(exposure),
        }),
      }),
    };
    const program = summed?.program ?? this.#displayProgram;
    this.display(program, uniforms, { Frame: frame, Flames: flames }, 1, summed?.textures);
  }

  /** The sum that a frame's surfaces are, or will be. */
  #summedIn({ canDefer, features }: FrameSettings): SummedSurfaces | null {
    return canDefer && features.candle ? this.#summed : null;
  }

  /** Looks at all flames: the first wick's may have become higher. */
  #frameFlames({ wick }: World["flame"]): void {
    if (wick === this.#firstWick) return;
    this.#firstWick = wick;
    this.#bounds = this.#boundsWith(wick);
    this.#hasDepth = false;
    this.#summed?.dispose(); // its images are of another camera
  }

  #viewOf(world: World): View {
    this.#frameFlames(world.flame);
    const { magnification, ...camera } = frameBox(this.#bounds, this.aspect);
    const flames: readonly RootedFlame[] = [carriedFlame(world), ...world.standing];
    const rooted = flames.map((one, i) => ({ ...one, ...this.#lights.wicks[i]! }));
    const { key, exposure } = this.#meter.measure(rooted);
    for (const [i, pass] of this.#resources.shadows.entries()) {
      finish(pass.update(this.#casters, shadowOrigin(rooted[i]!)));
    }
    // The page around has the same brightness for one flame and for sixteen.
    const studio = (STUDIO * MOST_EXPOSURE) / exposure;
    return { rooted, camera, magnification, key, exposure, studio };
  }

  /** Continues the images of a sum. True when all are drawn. */
  #proceed(summed: SummedSurfaces, view: View, { features }: FrameSettings): boolean {
    this.#current = { view, features };
    const { shadows, translucency, normalMaps } = features;
    return summed.proceed(this.size, view.rooted, [shadows, translucency, normalMaps]);
  }

  #drawInLight(light: number, target: RenderTarget, part: Box): void {
    const { view, features } = this.#current!;
    const { alone: flames } = this.#resources;
    const places = this.#summed!.groups.flamesOf(view.rooted)[light]!;
    flames.update(this.#lights.atRest(view.rooted, places, features.shadows));
    const illumination = {
      flames,
      environment: light === STUDIO_LIGHT ? TAPER.color : NONE,
      bounce: light === BOUNCE_LIGHT ? TAPER.color : NONE,
      translucency: features.translucency,
    };
    this.#drawSurfaces(this.#opaque, target, illumination, { scissor: part });
  }

  #drawSurfaces(
    surfaces: readonly Surface[],
    target: RenderTarget,
    { flames, environment, bounce, translucency }: Illumination,
    { scissor, isDepthKept }: { readonly scissor?: Box; readonly isDepthKept?: boolean } = {},
  ): void {
    const { frame, atlas } = this.#resources;
    for (const { mesh, uniforms, isClear, isTransmissive } of surfaces) {
      this.gpu.draw({
        program: isTransmissive ? this.#programOf({}) : this.#surfaceProgram,
        target,
        scissor,
        vertexArray: mesh.vertexArray,
        textures: { ...mesh.textures, uShadow: atlas.depth },
        sampling: surfaceSampling(this.tier),
        uniforms: {
          ...uniforms,
          ...(translucency ? {} : { uWax: 0 }),
          uEnvironment: environment,
          uBounce: bounce,
          uPlacement: [0, 0, 0, 0],
        },
        blocks: { Frame: frame, Flames: flames },
        blend: isClear ? "premultiplied" : "replace",
        depth: isClear || isDepthKept ? "test" : "test-and-write",
        cull: isClear || mesh.isDoubleSided ? "none" : "back",
      });
    }
  }

  /** Of a frame that is a sum it draws the surfaces first. */
  override readRadiance(box: Box): Float32Array {
    const sum = this.#lastSum;
    if (sum) this.drawFrame(sum.world, { ...sum.settings, canDefer: false });
    return super.readRadiance(box);
  }

  /** Frees all but the programs, which are shared. */
  override dispose(): void {
    super.dispose();
    this.#summed?.dispose();
    this.#release();
  }
}

const scaled = (color: readonly number[], factor: number) =>
  color.map((channel) => channel * factor);

function tapsOf({ name }: Tier, flames: number): number {
  return Math.max(Math.round((TAPS[name] * 4) / Math.max(flames, 4)), 4);
}

function surfaceOf(mesh: Mesh): Surface {
  const { material } = mesh.part;
  const isClear = material.alphaMode === "blend" || material.transmission > 0;
  return {
    mesh,
    isClear,
    isTransmissive: material.transmission >= 0.5,
    uniforms: {
      ...mesh.uniforms,
      uWax: material.isWax ? 1 : 0,
      uWick: mesh.isWick ? 1 : 0,
      uTransmission: material.transmission,
      uOpacity: isClear ? 1 : 0,
    },
  };
}
