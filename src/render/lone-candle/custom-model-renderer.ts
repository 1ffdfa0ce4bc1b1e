import displayFrag from "../../../shaders/candle/custom-display.frag";
import surfaceFrag from "../../../shaders/candle/custom-surface.frag";
import surfaceVert from "../../../shaders/mesh/mesh.vert";
import type { Model } from "../../assets/model.js";
import type { Gpu, Program, RenderTarget, Texture } from "../../gl/gpu.js";
import { carriedFlame, type RootedFlame, TAPER } from "../../light/flame-light.js";
import type { Bounds } from "../../world/geometry.js";
import type { Wick } from "../../world/standing-candle.js";
import type { World } from "../../world/world.js";
import type { FrameSettings } from "../frame-settings.js";
import { type Mesh, plainTextures, surfaceSampling, uploadModel } from "../mesh/mesh.js";
import type { Tier } from "../quality.js";
import { FlamePass, standingWick } from "../volumetric/flame-pass.js";
import { boundsWithFlames, frameBox } from "./custom-framing.js";
import { FlameLights } from "./flame-lights.js";
import { FlameShadows } from "./flame-shadows.js";
import { LightMeter, MOST_EXPOSURE } from "./light-meter.js";
import { LoneRenderer, type SmokePassOf } from "./lone-renderer.js";

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
/** Texels of a shadow cube's side, at the cheapest tier and at all others. */
const FACE = { low: 128, others: 256 } as const;

/** GPU objects of one model on a context that others draw on, too. */
function createResources(gpu: Gpu, program: Program, model: Model, flames: number, face: number) {
  return {
    meshes: uploadModel(gpu, model),
    shadows: new FlameShadows(gpu, flames, face),
    frame: gpu.uniformBlock(program, "Frame"),
    flames: gpu.uniformBlock(program, "Flames"),
    flame: new FlamePass(gpu),
  };
}

/** Light of a frame, beside its flames. */
interface Illumination {
  readonly atlas: Texture;
  /** Luminance of the model's middle tones, cd/m². */
  readonly key: number;
  /** Factor on the studio's light. */
  readonly studio: number;
  /** Whether wax glows. */
  readonly translucency: boolean;
}

/** Material of a mesh in the terms of candle/custom-surface.frag. */
interface Surface {
  readonly mesh: Mesh;
  readonly isClear: boolean;
  readonly uniforms: Readonly<Record<string, number | readonly number[]>>;
}

/** A visitor's own candles over the page's background: one to sixteen flames on a model. */
export class CustomModelRenderer extends LoneRenderer {
  readonly #surfaceProgram: Program;
  readonly #displayProgram: Program;
  readonly #resources: ReturnType<typeof createResources>;
  readonly #release: () => void;
  readonly #surfaces: readonly Surface[];
  readonly #casters: readonly Mesh[];
  readonly #bounds: Bounds;
  readonly #meter: LightMeter;
  readonly #lights = new FlameLights();

  constructor(gpu: Gpu, model: Model, wicks: readonly Wick[], tier: Tier, smokePass: SmokePassOf) {
    super(gpu, tier, smokePass);
    this.#bounds = boundsWithFlames(model.bounds, wicks);
    this.#surfaceProgram = gpu.program("candle/custom-surface", surfaceVert, surfaceFrag, {
      defines: { SHADOW_TAPS: tapsOf(tier, wicks.length) },
    });
    this.#displayProgram = gpu.pass("candle/custom-display", displayFrag);
    const face = tier.name === "low" ? FACE.low : FACE.others;
    plainTextures(gpu); // outlive the model
    const { made, release } = gpu.scoped(() =>
      createResources(gpu, this.#surfaceProgram, model, wicks.length, face),
    );
    this.#resources = made;
    this.#release = release;
    this.#surfaces = made.meshes.map(surfaceOf);
    this.#casters = this.#surfaces.filter(castsShadow).map(({ mesh }) => mesh);
    this.#meter = new LightMeter(
      this.#casters.map(({ part }) => part),
      wicks.map(({ position }) => position),
    );
  }

  protected drawFrame(world: World, settings: FrameSettings): void {
    const { frame, flames, flame, shadows } = this.#resources;
    const { features } = settings;
    const { magnification, ...camera } = frameBox(this.#bounds, this.aspect);
    const rooted: readonly RootedFlame[] = [carriedFlame(world), ...world.standing];
    const { key, exposure } = this.#meter.measure(rooted);
    const drawn = this.begin(frame, camera, exposure, settings);
    const { target, clip } = drawn;
    const glare = features.bloom ? Math.sqrt(exposure / MOST_EXPOSURE) : 0;
    flames.update(this.#lights.members(rooted, clip, features.shadows, glare));
    const roots = rooted.map(({ root }) => root);
    const atlas = shadows.render(roots, this.#casters);
    // The page around has the same brightness for one flame and for sixteen.
    const studio = (STUDIO * MOST_EXPOSURE) / exposure;
    const scene = { atlas, key, studio, translucency: features.translucency };
    if (features.candle) this.#drawSurfaces(target, scene, false);
    for (const one of features.volume ? rooted : []) {
      flame.render(target, frame, standingWick(one), this.tier.physical.flameSteps);
    }
    if (features.smoke) {
      const environment = TAPER.color.map((channel) => channel * studio);
      this.drawSmoke(world, drawn, frame, environment);
    }
    if (features.candle) this.#drawSurfaces(target, scene, true);
    const uniforms = {
      uVibrance: VIBRANCE,
      uMagnification: magnification,
      uHighlights: FLAME_STOPS / (FLAME_STOPS + Math.log2(exposure / MOST_EXPOSURE)),
    };
    this.display(this.#displayProgram, uniforms, { Frame: frame, Flames: flames });
  }

  /** Draws what is opaque, or what is clear, over flames and all. */
  #drawSurfaces(
    target: RenderTarget,
    { atlas, key, studio, translucency }: Illumination,
    isClear: boolean,
  ): void {
    const { frame, flames, shadows } = this.#resources;
    for (const { mesh, uniforms, isClear: isThis } of this.#surfaces) {
      if (isThis !== isClear) continue;
      this.gpu.draw({
        program: this.#surfaceProgram,
        target,
        vertexArray: mesh.vertexArray,
        textures: { ...mesh.textures, uShadowAtlas: atlas },
        sampling: surfaceSampling(this.tier),
        uniforms: {
          ...uniforms,
          ...(translucency ? {} : { uWax: 0 }),
          uEnvironment: TAPER.color.map((channel) => channel * studio),
          uBounce: TAPER.color.map((channel) => channel * key * BOUNCE),
          uPlacement: [0, 0, 0, 0],
          uShadowTiles: shadows.tiles,
          uShadowFace: shadows.face,
        },
        blocks: { Frame: frame, Flames: flames },
        blend: isClear ? "premultiplied" : "replace",
        depth: isClear ? "test" : "test-and-write",
        cull: isClear || mesh.isDoubleSided ? "none" : "back",
      });
    }
  }

  /** Frees all but the programs, which are shared. */
  override dispose(): void {
    super.dispose();
    this.#release();
  }
}

function tapsOf({ name }: Tier, flames: number): number {
  return Math.max(Math.round((TAPS[name] * 4) / Math.max(flames, 4)), 4);
}

function surfaceOf(mesh: Mesh): Surface {
  const { material } = mesh.part;
  const isClear = material.alphaMode === "blend" || material.transmission > 0;
  return {
    mesh,
    isClear,
    uniforms: {
      ...mesh.uniforms,
      uWax: material.isWax ? 1 : 0,
      uWick: mesh.isWick ? 1 : 0,
      uTransmission: material.transmission,
      uOpacity: isClear ? 1 : 0,
    },
  };
}

/** Wicks stand in their own flames, and clear surfaces transmit light. */
function castsShadow({ isClear, uniforms }: Surface): boolean {
  return !isClear && uniforms.uWick === 0;
}
