import gatherFrag from "../../../shaders/opaque/gather-inverse-depth.frag";
import lightingFrag from "../../../shaders/opaque/lighting.frag";
import type {
  Draw,
  Gpu,
  Program,
  RenderTarget,
  Texture,
  TextureFormat,
  UniformBlock,
} from "../../gl/gpu.js";
import type { Steps } from "../../world/steps.js";
import { type CachedLight, candlesOf, moonOf } from "../cached-light.js";
import { floats } from "../float-format.js";
import type { FrameInput, Size } from "../frame-input.js";
import type { GBuffer } from "../gbuffer/gbuffer.js";
import type { Captures } from "../gi/light-captures.js";
import { type CaptureLight, lightBlock, shadingLight } from "../light-block.js";
import type { PhysicalTier, ShadowQuality } from "../quality.js";
import { SCHEDULE } from "../schedule.js";
import { lightingInputs, moonLighting, representativeColor } from "./cached-lighting.js";
import { MultiLightInputs } from "./multi-light-inputs.js";
import type { OpaqueLayer } from "./opaque-stage.js";

/** Lighting of a frame, and the light that it is per candela of. */
interface Lit extends Pick<OpaqueLayer, "uniforms"> {
  readonly textures: { readonly uLighting: Texture };
  readonly Light: UniformBlock;
}

/** Lighting texels along an edge for each pixel, by kind of the G-buffer. */
const RATE = { reduced: 0.2, full: 0.5 } as const;

/** Deferred lighting at a lower rate than the G-buffer's: direct and indirect, for each candela of the flame's. */
export class LightingPass {
  readonly format: TextureFormat;
  readonly frame: UniformBlock;
  readonly light: UniformBlock;
  /** Of lighting at rest, by one flame. */
  readonly full: Program;
  readonly #gpu: Gpu;
  readonly #tier: PhysicalTier;
  readonly #gather: Program;
  /** The flame that the lighting is of. */
  readonly #shadingLight: UniformBlock;
  /** The light that represents all, of which the lighting in motion is. */
  readonly #representative: UniformBlock;
  #isOfAll = false;
  #standing: MultiLightInputs | null = null;
  #key = "";
  #light: CaptureLight | null = null;
  #fullTarget: RenderTarget | null = null;
  #reducedTarget: RenderTarget | null = null;
  #reducedMoon: RenderTarget | null = null;
  /** Inverse depths of four neighbours in each texel, for the bilateral upsampling. */
  #gathered: RenderTarget | null = null;

  constructor(gpu: Gpu, tier: PhysicalTier) {
    this.#gpu = gpu;
    this.#tier = tier;
    this.full = this.#program(tier.shadow, { REDUCED: 0 });
    this.#gather = gpu.pass("opaque/gather-inverse-depth", gatherFrag);
    this.format = floats(gpu, 4);
    this.frame = gpu.uniformBlock(this.full, "Frame");
    this.light = gpu.uniformBlock(this.full, "Light");
    this.#shadingLight = gpu.uniformBlock(this.full, "Light");
    this.#representative = gpu.uniformBlock(this.full, "Light");
  }

  #program({ search, taps, bias }: ShadowQuality, kind: Readonly<Record<string, number>>): Program {
    const defines = { SHADOW_SEARCH: search, SHADOW_TAPS: taps, SHADOW_BIAS: bias, ...kind };
    return this.#gpu.pass("opaque/lighting", lightingFrag, { defines });
  }

  /** Of lighting in motion: by the flame alone, or by all lights at once, which then share what they compute. */
  reducedProgram(cached: readonly CachedLight[]): Program {
    return this.#program(this.#reducedShadow, {
      REDUCED: 1,
      ...(cached.length > 0 && { OF_ALL: 1 }),
      ...(candlesOf(cached).length > 0 && { CANDLES: this.#tier.mostCandles }),
      ...(moonOf(cached) && { WITH_MOON: 1 }),
    });
  }

  /** Texels four times as large are averaged over as many shadow taps again. */
  get #reducedShadow(): ShadowQuality {
    const { shadow } = this.#tier;
    const [search, taps] = [Math.ceil(shadow.search / 2), Math.ceil(shadow.taps / 2)];
    return { ...shadow, search, taps };
  }

  resize({ width, height }: Size): void {
    const targets = [this.#reducedTarget, this.#reducedMoon, this.#fullTarget, this.#gathered];
    for (const old of targets) old?.dispose();
    const target = (
      kind: keyof typeof RATE,
      color: readonly TextureFormat[],
      name: string = kind,
      filter: "nearest" | "linear" = "linear",
    ) =>
      this.#gpu.renderTarget({
        label: `lighting/${name}`,
        width: Math.max(1, Math.ceil(width * RATE[kind])),
        height: Math.max(1, Math.ceil(height * RATE[kind])),
        color,
        filter,
      });
    this.#reducedTarget = target("reduced", [this.format, floats(this.#gpu, 1)]);
    this.#reducedMoon = target("reduced", [this.format], "moon");
    this.#gathered = target("reduced", [this.format], "gathered", "nearest");
    this.#fullTarget = target("full", [this.format]);
    this.#key = "";
  }

  get size(): Size {
    return this.#fullTarget ?? { width: 1, height: 1 };
  }

  *render(
    frame: FrameInput,
    gbuffer: GBuffer,
    { shadow, irradiance, cached }: Captures,
  ): Steps<Lit> {
    const { kind, history } = gbuffer;
    const reprojection = kind === "reprojected" ? history : null;
    const isReduced = kind !== "full";
    const target = (isReduced ? this.#reducedTarget : this.#fullTarget)!;
    // A reprojected frame has the lighting of the frame that it was lit in.
    if (!reprojection) this.#isOfAll = isReduced && cached.length > 0;
    const lit = {
      textures: {
        uLighting: target.color,
        ...(isReduced && { uInverseDepthGather: this.#gathered!.color }),
      },
      uniforms: {},
      Light: this.#isOfAll ? this.#representative : this.light,
    };
    if (reprojection) {
      const { room: uPreviousFromCurrentRoom, held: uPreviousFromCurrentHeld } = reprojection;
      return { ...lit, uniforms: { uPreviousFromCurrentRoom, uPreviousFromCurrentHeld } };
    }
    const { features, canDefer } = frame.settings;
    const { shadows, indirect, specular, candle } = features;
    const steps = SCHEDULE.lighting.deferred;
    const { captureOrigin } = shadow;
    const exact = { ...shadingLight(frame.world, candle, steps), captureOrigin };
    // A flame that sways about the middle between two steps would be shaded for again and again.
    const staysNear = canDefer && !isReduced && areOneStepApart(exact, this.#light ?? exact, steps);
    const light = staysNear ? (this.#light ?? exact) : exact;
    this.#light = light;
    const { revision } = irradiance;
    const key = JSON.stringify([gbuffer.key, light, revision, shadows, indirect, specular]);
    if (key === this.#key && !this.#isOfAll) return lit;
    this.#key = "";
    this.#shadingLight.update(light);
    const program = isReduced ? this.reducedProgram(cached) : this.full;
    program.start();
    const all = this.#isOfAll ? this.#ofAll(frame, program, { shadow, irradiance, cached }) : null;
    const { textures, uniforms } = lightingInputs(frame, gbuffer, target);
    yield;
    const moon = isReduced ? moonOf(cached) : null;
    const uMoonLighting = this.#reducedMoon;
    if (moon && uMoonLighting) {
      this.#gpu.draw({
        program: moonLighting(this.#gpu, this.#reducedShadow, 1),
        target: uMoonLighting,
        textures: { ...textures, uMoonMap: moon.shadow },
        uniforms,
        blocks: { Frame: this.frame, Moon: moon.block },
      });
      yield;
    }
    this.#gpu.draw({
      program,
      target,
      textures: {
        ...textures,
        uShadow: shadow.depth,
        ...irradiance.textures,
        uSupport: irradiance.support,
        ...irradiance.surfels,
        ...all?.textures,
        ...(moon && uMoonLighting && { uMoonLighting: uMoonLighting.color }),
      },
      uniforms: { ...uniforms, ...all?.uniforms },
      blocks: {
        Frame: this.frame,
        Light: this.#shadingLight,
        Volume: irradiance.block,
        ...all?.blocks,
      },
    });
    yield;
    if (isReduced) {
      const uInverseDepth = target.colors[1]!;
      const gathered = this.#gathered!;
      this.#gpu.draw({ program: this.#gather, target: gathered, textures: { uInverseDepth } });
    }
    this.#key = key;
    return lit;
  }

  /** What lighting by all lights reads beside lighting by the flame. */
  #ofAll(
    { world, settings }: FrameInput,
    program: Program,
    { shadow, irradiance, cached }: Captures,
  ): Required<Pick<Draw, "textures" | "uniforms" | "blocks">> {
    const flame = lightBlock(world, settings.features.candle);
    const { intensity } = flame;
    const uColor = representativeColor(intensity, cached);
    this.#representative.update({ ...flame, intensity: uColor });
    this.#shadingLight.update({ intensity });
    this.#standing ??= new MultiLightInputs(this.#gpu, this.format);
    const { textures, blocks } = this.#standing.inputs(
      program,
      cached,
      { shadow, irradiance },
      intensity,
    );
    const moon = moonOf(cached);
    const [candle] = candlesOf(cached);
    return {
      textures: {
        ...textures,
        ...(candle && { uStandingSupport: candle.irradiance.support }),
      },
      uniforms: { uColor, ...(moon && { uMoonlight: moon.intensity }) },
      blocks,
    };
  }
}

/** Whether two lights that were shaded for in steps differ by no more than one. */
function areOneStepApart(
  one: CaptureLight,
  other: CaptureLight,
  { distance, axis }: Record<"distance" | "axis", number>,
): boolean {
  return Object.entries(one).every(([name, value]) => {
    const limit = 1.01 * (name === "along" ? axis : distance);
    const others = [other[name] ?? Number.NaN].flat();
    return [value].flat().every((x, i) => Math.abs(x - others[i]!) <= limit);
  });
}
