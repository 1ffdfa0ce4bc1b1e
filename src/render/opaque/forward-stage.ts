import type { Box, Draw, Gpu, Program, RenderTarget, Texture, UniformBlock } from "../../gl/gpu.js";
import { luma, type Rgb } from "../../light/color.js";
import type { Bounds } from "../../world/geometry.js";
import type { Steps } from "../../world/steps.js";
import { type CachedLight, candlesOf, isMoonAlone, moonOf } from "../cached-light.js";
import { frustumTest } from "../camera.js";
import type { FrameInput, ModelInstance, Size } from "../frame-input.js";
import type { Captures } from "../gi/light-captures.js";
import { type CaptureLight, flameIntensity, shadingLight } from "../light-block.js";
import { type Mesh, surfaceSampling } from "../mesh/mesh.js";
import { normalMapVisibilityOf } from "../mesh/normal-map-visibility.js";
import { visibleRuns } from "../mesh/visible-runs.js";
import { isSoftware, type Tier } from "../quality.js";
import { SCHEDULE } from "../schedule.js";
import { boundsNearFlame, clipOfBox } from "../screen-bounds.js";
import type { CompositedFrame } from "../volumetric/volumetric-target.js";
import { CandleLayers } from "./candle-layers.js";
import { Checkerboard } from "./checkerboard.js";
import { ENVIRONMENT_BRDF_SIZE, tabulateEnvironmentBrdf } from "./environment-brdf.js";
import {
  areForwardProgramsCompiled,
  forwardComposite,
  forwardProgram,
  nightProgram,
  samplesOf,
} from "./forward-programs.js";
import { type LightPass, lightPass, nightPass } from "./light-pass.js";
import { MultiLightInputs } from "./multi-light-inputs.js";
import type { FrameBlocks, OpaqueLayer, OpaqueStage } from "./opaque-stage.js";
import { RestTurns } from "./rest-turns.js";

/** What surfaces are drawn to: a target, or a part of a larger frame that it holds. */
interface SurfacePass
  extends Pick<Draw, "target" | "viewport" | "scissor" | "textures" | "uniforms"> {
  /** Whether what lies in a box is drawn. Default: what is in the view frustum, a mesh in one draw. */
  readonly isVisible?: (box: Bounds) => boolean;
  /** Whether a mesh is drawn. Default: each is. */
  readonly isDrawn?: (mesh: Mesh) => boolean;
  /** Standing candles that are shaded for as well, all flames as they burn. Default: none. */
  readonly candles?: readonly CachedLight[];
  /** Of the carried flame beside them, candela. Default: as it burns. */
  readonly carried?: Rgb;
}

/** The opaque stage for GPUs: forward shading, multisampled. Kept until camera, models or light have moved. */
export class ForwardStage implements OpaqueStage {
  readonly format = "RGBA16F";
  readonly blocks: FrameBlocks;
  readonly #gpu: Gpu;
  readonly #tier: Tier;
  readonly #program: Program;
  /** The flame that the radiance is of. */
  readonly #shadingLight: UniformBlock;
  readonly #environmentBrdf: Texture;
  #samples: RenderTarget | null = null;
  #resolved: RenderTarget | null = null;
  /** Moonlight in the last frame that was shaded. */
  #moon: CachedLight | null = null;
  readonly #candleLayers: CandleLayers;
  /** The standing candles that burn in it. */
  #candles: readonly CachedLight[] = [];
  #standing: MultiLightInputs | null = null;
  readonly #checkerboard: Checkerboard | null;
  /** Whether a part of the last frame was kept in a light that has moved. */
  #isClamped = false;
  /** Whether the radiance is of all flames as they burn: in motion, and until each candle has its layer. */
  #isOfAll = false;
  /** What the radiance depends on beside the flame's place, and that place. */
  #key = "";
  #lightKey = "";
  readonly #turns = new RestTurns();

  constructor(gpu: Gpu, tier: Tier) {
    this.#gpu = gpu;
    this.#tier = tier;
    this.#program = forwardProgram(gpu, tier, { isMoonlit: false });
    this.#candleLayers = new CandleLayers(gpu);
    this.blocks = {
      Frame: gpu.uniformBlock(this.#program, "Frame"),
      Light: gpu.uniformBlock(this.#program, "Light"),
    };
    // Software shades what depth hides, and would gain nothing.
    const isKeeping = tier.physical.opaque === "forward" && !isSoftware(gpu.renderer);
    this.#checkerboard = isKeeping ? new Checkerboard(gpu, this.blocks.Frame) : null;
    this.#shadingLight = gpu.uniformBlock(this.#program, "Light");
    this.#environmentBrdf = gpu.share("environment BRDF", () =>
      gpu.texture({
        label: "environment BRDF",
        format: "RG16F",
        source: {
          width: ENVIRONMENT_BRDF_SIZE,
          height: ENVIRONMENT_BRDF_SIZE,
          data: tabulateEnvironmentBrdf(),
        },
      }),
    );
  }

  resize({ width, height }: Size): void {
    const { samples } = this.#tier;
    this.#samples?.dispose();
    this.#resolved?.dispose();
    this.#checkerboard?.release();
    const size = { width, height, color: [this.format] as const, depth: "texture" as const };
    this.#samples =
      samples > 1 ? this.#gpu.renderTarget({ label: "forward/samples", ...size, samples }) : null;
    this.#resolved = this.#gpu.renderTarget({ label: "forward/radiance", ...size });
    this.#key = "";
    this.#candleLayers.resize({ width, height });
  }

  *shade(input: FrameInput, captures: Captures): Steps<OpaqueLayer> {
    if (!this.#resolved?.depth) throw new Error("The forward stage has no size yet.");
    const settings = this.#checkerboard?.settle(input.settings) ?? input.settings;
    const frame = { ...input, settings };
    const { world, instances } = frame;
    const { features, inspect } = settings;
    this.#checkerboard?.prepare(instances);
    const light = {
      ...shadingLight(world, features.candle, SCHEDULE.lighting.forward),
      captureOrigin: captures.shadow.captureOrigin,
    };
    this.#moon = inspect === "normals" ? null : moonOf(captures.cached);
    this.#candles = inspect === "normals" ? [] : candlesOf(captures.cached);
    const frameKey = JSON.stringify([
      [...frame.clipFromWorld],
      features,
      inspect === "normals",
      samplesOf(this.#tier, settings.isMoving),
      instances.map(({ placement }) => placement),
    ]);
    this.#updateLayers(frame, frameKey);
    yield;
    const isNight = this.isNight(frame, captures);
    const key = JSON.stringify([frameKey, captures.irradiance.revision, this.#moon?.key, isNight]);
    const lightKey = JSON.stringify(light);
    const hasMoved = lightKey !== this.#lightKey;
    if (hasMoved) this.#turns.begin();
    let drawn = { radiance: this.#resolved.color, isKept: false };
    const isWhole = key !== this.#key || (this.#turns.isStale && !settings.canDefer);
    if (isWhole) this.#turns.end();
    const candles = this.#isOfAll ? this.#candles : [];
    const isStill = isNight || !(this.#isOfAll || world.candle.isHeld);
    const target = this.#samples;
    if (isWhole && settings.isMoving && this.#checkerboard && target) {
      this.#gpu.clear(target, [0, 0, 0, this.#moon?.background ?? 1]);
      const lighting = {
        key: JSON.stringify([inspect, this.#moon?.key, isNight, candles.map(({ key }) => key)]),
        isStill,
        flame: this.#isOfAll ? 1 : luma(flameIntensity(world)),
        moon: luma(this.#moon?.intensity ?? [0, 0, 0]),
      };
      const shade = () => this.draw(frame, light, captures, { target, candles });
      drawn = this.#checkerboard.draw(frame, lighting, target, this.#resolved, shade);
    } else if (isWhole) {
      this.#drawBox(frame, light, captures, null);
    } else {
      const near = hasMoved ? boundsNearFlame(frame, this.#resolved) : null;
      const box = this.#turns.next(near, light.position, this.#resolved);
      if (box) this.#drawBox(frame, light, captures, box);
    }
    // Else the samples hold but a part of the frame.
    this.#key = drawn.isKept ? "" : key;
    this.#isClamped = drawn.isKept && !isStill;
    this.#lightKey = lightKey;
    return {
      kind: "full",
      textures: { uRadiance: drawn.radiance, uDepth: this.#resolved.depth },
      uniforms: {},
      blocks: this.blocks,
      depth: this.#resolved.depth,
      motion: 0,
    };
  }

  /** Draws a box of the frame anew, pixels, or all of it. */
  #drawBox(frame: FrameInput, light: CaptureLight, captures: Captures, box: Box | null): void {
    const target = this.#samples ?? this.#resolved!;
    const part = box && {
      scissor: box,
      isVisible: frustumTest(clipOfBox(box, target, frame.clipFromWorld)),
    };
    this.#gpu.clear(target, [0, 0, 0, this.#moon?.background ?? 1], box ?? undefined);
    const candles = this.#isOfAll ? this.#candles : [];
    this.draw(frame, light, captures, { target, candles, ...part });
    if (this.#samples) this.#gpu.resolve(this.#samples, this.#resolved!, box ?? undefined);
  }

  /** Shades the layers of the standing candles: none in motion, afterwards one a frame, else all. */
  #updateLayers(frame: FrameInput, frameKey: string): void {
    const { isMoving, canDefer } = frame.settings;
    const wasOfAll = this.#isOfAll;
    // Compiled while the camera rests.
    const canShadeAll =
      canDefer &&
      this.#candles.length > 0 &&
      areForwardProgramsCompiled(
        this.#gpu,
        this.#tier,
        { isMoonlit: this.#moon !== null, hasCandles: true },
        frame.instances.flatMap(({ meshes }) => meshes),
      );
    this.#isOfAll = canShadeAll && isMoving;
    const isApart = this.#candles.length > 0 && !this.#isOfAll;
    if (!isMoving || isApart) this.#checkerboard?.release();
    if (this.#isOfAll) {
      // The previous frame takes their place.
      if (this.#checkerboard) this.#candleLayers.release();
    } else {
      const most = canShadeAll && wasOfAll ? 1 : this.#candles.length;
      // Each is shaded in the targets of the flame's own layer, which is drawn anew afterwards.
      const shade = (candle: CachedLight) => this.#shadeCandle(frame, candle);
      const hasShaded = this.#candleLayers.update(this.#candles, frameKey, shade, most);
      if (hasShaded) this.#key = "";
      this.#isOfAll = canShadeAll && wasOfAll && hasShaded;
    }
    if (wasOfAll || this.#isOfAll) this.#key = "";
  }

  #shadeCandle(frame: FrameInput, { light, shadow, irradiance }: CachedLight): RenderTarget {
    const resolved = this.#resolved!;
    const target = this.#samples ?? resolved;
    this.#gpu.clear(target, [0, 0, 0, 1]);
    const captured = { depth: shadow, captureOrigin: light!.position, isNew: false };
    this.draw(frame, light!, { shadow: captured, irradiance, cached: [] }, { target });
    if (this.#samples) this.#gpu.resolve(this.#samples, resolved);
    return resolved;
  }

  /** Draws the surfaces for a flame of 1 cd and a moon of 1 lx, or for all flames. */
  draw(
    frame: FrameInput,
    light: CaptureLight,
    captures: Captures,
    {
      isVisible,
      isDrawn = () => true,
      candles = [],
      carried,
      textures,
      uniforms,
      ...target
    }: SurfacePass,
  ): void {
    const moon = frame.settings.inspect === "normals" ? null : moonOf(captures.cached);
    const context = {
      gpu: this.#gpu,
      tier: this.#tier,
      blocks: { Frame: this.blocks.Frame, Light: this.#shadingLight },
    };
    const pass =
      moon && this.isNight(frame, captures)
        ? nightPass(context, moon)
        : lightPass(context, captures, moon, candles.length > 0);
    this.#shadingLight.update(light);
    Object.assign(pass.textures, textures);
    if (candles.length > 0) {
      const intensity = carried ?? flameIntensity(frame.world);
      this.#shadingLight.update({ intensity });
      this.#standing ??= new MultiLightInputs(this.#gpu, this.format);
      const inputs = this.#standing.inputs(pass.programOf(), candles, captures, intensity);
      Object.assign(pass.textures, inputs.textures);
      Object.assign(pass.blocks, inputs.blocks);
    }
    const isInView = isVisible ?? frustumTest(frame.clipFromWorld);
    for (const instance of frame.instances) {
      for (const mesh of instance.meshes.filter(isDrawn)) {
        const runs = visibleRuns(mesh, instance.placement, isInView, isVisible ? undefined : 1);
        if (runs.length === 0) continue;
        const draw = this.#drawOf(frame, instance, mesh, pass, uniforms);
        for (const run of runs) this.#gpu.draw({ ...draw, ...target, ...run });
      }
    }
  }

  /** Whether it shades for the moon alone; where frames may wait, once the program is compiled. */
  isNight({ world, settings }: FrameInput, { cached }: Captures): boolean {
    if (!isMoonAlone(world, cached) || !moonOf(cached)?.virtual) return false;
    if (settings.inspect === "normals") return false;
    return !settings.canDefer || nightProgram(this.#gpu, this.#tier).isCompiled;
  }

  #drawOf(
    { settings }: FrameInput,
    { placement }: ModelInstance,
    mesh: Mesh,
    { programOf, textures, blocks, isNight }: LightPass,
    uniforms: Draw["uniforms"],
  ): Omit<Draw, "target"> {
    const { shadows, indirect, specular, translucency } = settings.features;
    const last = isNight ? settings.isMoving : settings.inspect === "normals";
    return {
      program: programOf(mesh),
      vertexArray: mesh.vertexArray,
      textures: {
        ...mesh.textures,
        uEnvironmentBrdf: this.#environmentBrdf,
        uNormalMapVisibility: normalMapVisibilityOf(this.#gpu, mesh),
        ...textures,
      },
      sampling: surfaceSampling(this.#tier),
      uniforms: {
        ...mesh.uniforms,
        uPlacement: placement,
        ...(!isNight && {
          uWax: mesh.isWax && translucency ? 1 : 0,
          uIsWick: mesh.isWick ? 1 : 0,
          uIsPane: mesh.isPane ? 1 : 0,
          uSamples: samplesOf(this.#tier, settings.isMoving),
        }),
        uOrigin: [0, 0],
        ...uniforms,
        uFeatures: [shadows, indirect, specular, last].map(Number),
      },
      blocks,
      depth: "test-and-write",
      cull: mesh.isDoubleSided ? "none" : "back",
    };
  }

  composite(
    { settings }: FrameInput,
    layer: OpaqueLayer,
    { target }: CompositedFrame,
    region: Box,
  ): void {
    const moon = this.#moon;
    this.#gpu.draw({
      program: forwardComposite(this.#gpu, moon !== null, this.#isClamped),
      target,
      textures: { uRadiance: layer.textures.uRadiance! },
      uniforms: {
        uIsLight: settings.inspect === "normals" || this.#isOfAll ? 0 : 1,
        ...(moon && { uMoonlight: moon.intensity }),
      },
      blocks: { Light: layer.blocks.Light },
      scissor: region,
    });
    if (!this.#isOfAll) this.#candleLayers.add(this.#candles, target, region);
  }
}
