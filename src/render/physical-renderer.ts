import { mat4 } from "gl-matrix";
import surfaceVert from "../../shaders/mesh/mesh.vert";
import surfaceFrag from "../../shaders/opaque/forward.frag";
import type { Gpu } from "../gl/gpu.js";
import type { Program } from "../gl/program.js";
import type { RenderTarget } from "../gl/render-target.js";
import type { Texture } from "../gl/texture.js";
import type { TextureView } from "../gl/texture-view.js";
import type { UniformBlock } from "../gl/uniform-block.js";
import type { VertexArray } from "../gl/vertex-array.js";
import { emberRadiance } from "../light/flame-light.js";
import type { Inspection } from "../settings.js";
import { fieldOfViewOf } from "../world/field-of-view.js";
import type { ParticleLayer } from "../world/particle-layer.js";
import type { Solid } from "../world/solid.js";
import type { World } from "../world/world.js";
import { clipFromWorld, projectionScale } from "./camera.js";
import type { View } from "./frame-settings.js";
import { type IndirectDetail, IndirectPass, type IrradianceVolume } from "./gi/indirect-pass.js";
import { traceProbesIncrementally } from "./gi/probe-rays.js";
import { captureLight, lightBlock } from "./light-block.js";
import { groupTriangles } from "./mesh/clusters.js";
import { type Surface, sortedByArea, surfaceSampling, uploadModel } from "./mesh/mesh.js";
import { normalMapVisibilityOf } from "./mesh/normal-map-visibility.js";
import { ENVIRONMENT_BRDF_SIZE, tabulateEnvironmentBrdf } from "./opaque/environment-brdf.js";
import { BloomPass, shareOf } from "./post/bloom-pass.js";
import { DisplayPass, exposureFactor } from "./post/display-pass.js";
import { ExposurePass } from "./post/exposure-pass.js";
import { InspectPass } from "./post/inspect-pass.js";
import type { Tier } from "./quality.js";
import type { Models, Renderer } from "./renderer.js";
import { ShadowCasters } from "./shadow/shadow-casters.js";
import { ShadowPass } from "./shadow/shadow-pass.js";
import { type FlamePart, FlamePass, HANDLE_TURN } from "./volumetric/flame-pass.js";
import { HazePass } from "./volumetric/haze-pass.js";
import { MotesPass } from "./volumetric/motes-pass.js";
import { SmokePass } from "./volumetric/smoke-pass.js";
import type { VolumetricTarget } from "./volumetric/volumetric-target.js";
import { zoomOf } from "./zoom.js";

/** Shadow cube: texels along an edge, taps that look for what casts it, taps that soften it. */
const SHADOW: Readonly<Record<Tier["name"], { size: number; search: number; taps: number }>> = {
  low: { size: 128, search: 4, taps: 6 },
  medium: { size: 512, search: 12, taps: 24 },
  high: { size: 512, search: 16, taps: 32 },
  ultra: { size: 1024, search: 24, taps: 48 },
};
const INDIRECT: Readonly<Record<Tier["name"], IndirectDetail>> = {
  low: { surfels: 6, probes: [5, 3, 5], rays: 8, bounces: 4, testsVisibility: false },
  medium: { surfels: 8, probes: [6, 4, 6], rays: 10, bounces: 5, testsVisibility: true },
  high: { surfels: 16, probes: [14, 6, 14], rays: 10, bounces: 6, testsVisibility: true },
  ultra: { surfels: 16, probes: [14, 6, 14], rays: 12, bounces: 6, testsVisibility: true },
};
/** What of the room may be left out where it throws shadows and light, metres. */
const CASTER_DETAIL: Readonly<Record<Tier["name"], number>> = {
  low: 0.03,
  medium: 0.01,
  high: 0,
  ultra: 0,
};
const BLOOM_LEVELS: Readonly<Record<Tier["name"], number>> = {
  low: 3,
  medium: 5,
  high: 6,
  ultra: 6,
};
const NO_EMBER = [0, 0, 0] as const;
const BLACK = [0, 0, 0, 1] as const;
/** A haze that moves nothing, as a colour. */
const NOT_MOVED = [0.5, 0.5, 0.5, 1] as const;

/**
 * The room as a real flame lights it, in candela and metres: linear and high in range until `display`.
 */
export class PhysicalRenderer implements Renderer {
  readonly #gpu: Gpu;
  readonly #tier: Tier;
  readonly #surfaceProgram: Program;
  readonly #frame: UniformBlock;
  readonly #light: UniformBlock;
  readonly #flame: FlamePass;
  readonly #haze: HazePass;
  readonly #smoke: SmokePass;
  readonly #motes: MotesPass;
  readonly #casters: ShadowCasters;
  readonly #shadow: ShadowPass;
  readonly #indirect: IndirectPass;
  readonly #reflectance: Texture;
  readonly #bloom: BloomPass;
  readonly #exposure: ExposurePass;
  readonly #display: DisplayPass;
  readonly #room: readonly Surface[];
  readonly #candle: readonly Surface[];
  readonly #screen: VertexArray;
  /** Made when something is first looked at. */
  #inspector: InspectPass | null = null;
  #samples: RenderTarget | null = null;
  #radiance: RenderTarget | null = null;
  #veil: TextureView | null = null;
  #size = { width: 1, height: 1 };
  #clip = mat4.create();

  /** @param solid of the room, as it can be touched */
  constructor(gpu: Gpu, { room, candle }: Models, solid: Solid, tier: Tier) {
    this.#gpu = gpu;
    this.#tier = tier;
    this.#surfaceProgram = surfaceProgram(gpu, tier);
    this.#shadow = new ShadowPass(gpu, SHADOW[tier.name].size);
    this.#frame = gpu.uniformBlock(this.#surfaceProgram, "Frame");
    this.#light = gpu.uniformBlock(this.#surfaceProgram, "Light");
    this.#flame = new FlamePass(gpu);
    this.#haze = new HazePass(gpu);
    this.#smoke = new SmokePass(gpu);
    this.#motes = new MotesPass(gpu);
    const surfaces = uploadModel(gpu, room, groupTriangles);
    this.#room = sortedByArea(surfaces);
    this.#candle = uploadModel(gpu, candle, groupTriangles);
    this.#casters = new ShadowCasters(gpu, room, surfaces, CASTER_DETAIL[tier.name]);
    this.#screen = gpu.vertexArray("screen", { attributes: {}, count: 3 });
    const echoing = { model: room, solid, surfaces };
    this.#indirect = new IndirectPass(gpu, this.#screen, echoing, INDIRECT[tier.name]);
    this.#reflectance = gpu.share("reflectance", () =>
      gpu.texture({
        label: "reflectance",
        format: "RG16F",
        source: {
          width: ENVIRONMENT_BRDF_SIZE,
          height: ENVIRONMENT_BRDF_SIZE,
          data: tabulateEnvironmentBrdf(),
        },
      }),
    );
    this.#bloom = new BloomPass(gpu, this.#screen, BLOOM_LEVELS[tier.name], {
      format: "RGBA16F",
      isFrugal: false,
    });
    this.#exposure = new ExposurePass(gpu, this.#screen);
    this.#display = new DisplayPass(gpu, this.#screen);
  }

  resize(width: number, height: number): void {
    const { samples } = this.#tier;
    this.#size = { width, height };
    this.#samples?.dispose();
    this.#radiance?.dispose();
    this.#veil?.dispose();
    const size = { width, height, color: ["RGBA16F"] as const, depth: "texture" as const };
    this.#samples =
      samples > 1 ? this.#gpu.renderTarget({ label: "frame samples", ...size, samples }) : null;
    this.#radiance = this.#gpu.renderTarget({ label: "radiance", ...size });
    const { color } = this.#radiance;
    this.#veil = this.#gpu.textureView({ label: "veil", textures: [color], image: 0 });
    this.#haze.resize(width, height);
    this.#bloom.resize(width, height);
  }

  /** The body of the flame is no particles; dust and sparks are. */
  setLayers(world: World, layers: readonly ParticleLayer[]): void {
    this.#motes.setLayers(world, layers);
  }

  get particles(): number {
    return this.#motes.particles;
  }

  render(world: World, view: View): void {
    if (!this.#radiance) return;
    const target = this.#samples ?? this.#radiance;
    this.#updateBlocks(world, view);
    const light = captureLight(world, view.features.candle);
    const shadow = this.#shadow.render(this.#casters, light.position);
    const volume = this.#indirect.render(this.#casters, light);
    this.#gpu.clear(target, BLACK);
    const { inspect } = view;
    const part = partOf(inspect);
    if (!part) this.#drawSurfaces(target, view, this.#room, shadow, volume, [0, 0, 0, 0]);
    if (view.features.candle && !part) {
      const [x, y, z] = world.shown.foot;
      const place = [x, y, z, world.candle.yaw + HANDLE_TURN] as const;
      const ember = emberRadiance(world.flame.ember);
      this.#drawSurfaces(target, view, this.#candle, shadow, volume, place, ember);
    }
    const isLit = inspect !== "normals";
    if (isLit && view.features.volume) {
      this.#flame.render(target, this.#frame, world, this.#tier.name, part ?? "all");
    }
    if (this.#samples) this.#gpu.resolve(this.#samples, this.#radiance);
    if (isLit && !part) this.#drawAir(world, view, volume);
    const radiance = this.#radiance.color;
    const bloom = this.#bloom.render(radiance);
    const exposure = this.#exposure.render({ uRadiance: radiance }, world.pupil.lag);
    const textures = { uRadiance: radiance, uBloom: bloom, uExposure: exposure };
    const { depth } = this.#radiance;
    if (inspect !== "picture" && depth) {
      this.#inspector ??= new InspectPass(this.#gpu, this.#screen);
      this.#inspector.render(view, { ...textures, uDepth: depth, uShadow: shadow }, volume, {
        Frame: this.#frame,
        Light: this.#light,
      });
      return;
    }
    const place = { share: shareOf(this.#size, bloom), shift: [0, 0] } as const;
    this.#display.render(textures, place, view, this.#frame);
  }

  #updateBlocks(world: World, view: View): void {
    const { features } = view;
    const { player, shown } = world;
    const { width, height } = this.#size;
    const { yaw, pitch } = player;
    this.#clip = clipFromWorld(shown.eye, yaw, pitch, width / height, fieldOfViewOf(world));
    this.#frame.update({
      clipFromWorld: this.#clip,
      eyePosition: shown.eye,
      exposure: exposureFactor(view),
      viewport: [width, height],
      projectionScale: projectionScale(height) * zoomOf(world),
      normalMaps: features.normalMaps ? 1 : 0,
    });
    this.#light.update(lightBlock(world, features.candle));
  }

  #drawSurfaces(
    target: RenderTarget,
    { features, inspect }: View,
    surfaces: readonly Surface[],
    shadow: Texture,
    volume: IrradianceVolume,
    place: readonly [number, number, number, number],
    ember: readonly [number, number, number] = NO_EMBER,
  ): void {
    const { shadows, indirect, specular, translucency } = features;
    const showsNormals = inspect === "normals";
    const shown = [shadows, indirect, specular, showsNormals].map(Number);
    for (const surface of surfaces) {
      const {
        vertexArray,
        textures,
        baseColor,
        parameters,
        isDoubleSided,
        isWax,
        isWick,
        occlusionStrength,
      } = surface;
      this.#gpu.draw({
        program: this.#surfaceProgram,
        target,
        vertexArray,
        textures: {
          ...textures,
          uShadow: shadow,
          uEnvironmentBrdf: this.#reflectance,
          uNormalMapVisibility: normalMapVisibilityOf(this.#gpu, this.#screen, surface),
          uRadiosity: volume.radiosity,
          ...volume.textures,
        },
        sampling: surfaceSampling(this.#tier),
        uniforms: {
          uBaseColor: baseColor,
          uPlacement: place,
          uSurface: parameters,
          uOcclusionStrength: occlusionStrength,
          uWax: isWax && translucency ? 1 : 0,
          uEmber: isWick ? ember : NO_EMBER,
          uShown: shown,
        },
        blocks: { Frame: this.#frame, Light: this.#light, Volume: volume.block },
        depth: "test-and-write",
        cull: isDoubleSided ? "none" : "back",
      });
    }
  }

  /** Hot air and smoke, over what is solid and before the lens. */
  #drawAir(world: World, { features, isStill, inspect }: View, volume: IrradianceVolume): void {
    const { fumes, flame } = world;
    if (!fumes || !this.#radiance?.depth || !this.#veil) return;
    const veil: VolumetricTarget = { target: this.#veil, depth: this.#radiance.depth };
    const { color } = this.#radiance;
    const height = flame.isLit ? flame.height : 0;
    const [frame, light] = [this.#frame, this.#light];
    if (inspect === "haze") {
      this.#gpu.clear(veil.target, NOT_MOVED);
      this.#haze.render(veil, color, fumes.plume, height, frame, this.#clip, true);
      return;
    }
    if (features.haze) this.#haze.render(veil, color, fumes.plume, height, frame, this.#clip);
    if (features.dust && !isStill) {
      this.#motes.render("dust", veil, world, frame, light, volume);
    }
    if (features.smoke) this.#smoke.render(veil, fumes.smoke, frame, light, volume);
    if (features.sparks && !isStill) {
      this.#motes.render("spark", veil, world, frame, light, volume);
    }
  }

  readRadiance(x: number, y: number, width: number, height: number): Float32Array {
    if (!this.#radiance) return new Float32Array(width * height * 3);
    return this.#gpu.readRadiance(this.#radiance, x, y, width, height);
  }
}

function surfaceProgram(gpu: Gpu, { name }: Tier): Program {
  const { search, taps } = SHADOW[name];
  const defines = { SHADOW_SEARCH: search, SHADOW_TAPS: taps };
  return gpu.program("opaque/forward", surfaceVert, surfaceFrag, { defines });
}

/** Probes that look around in a frame: a few milliseconds. */
const PROBES_PER_FRAME = 16;

/**
 * Goes on with what takes long before a `PhysicalRenderer` can draw: compiling, and rays from the probes.
 *
 * @returns whether all of it is done
 */
export function preparePhysicalRenderer(
  gpu: Gpu,
  { room }: Models,
  solid: Solid,
  tier: Tier,
): boolean {
  const { isCompiled } = surfaceProgram(gpu, tier);
  const detail = INDIRECT[tier.name];
  return traceProbesIncrementally(solid, room, detail, PROBES_PER_FRAME) && isCompiled;
}

/** The part of the flame that is looked at alone; null where the room is seen. */
function partOf(inspect: Inspection): FlamePart | null {
  if (inspect === "soot" || inspect === "temperature") return "soot";
  return inspect === "blue" ? "blue" : null;
}
