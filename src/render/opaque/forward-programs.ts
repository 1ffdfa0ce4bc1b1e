import meshVert from "../../../shaders/mesh/mesh.vert";
import forwardFrag from "../../../shaders/opaque/forward.frag";
import compositeFrag from "../../../shaders/opaque/forward-composite.frag";
import nightFrag from "../../../shaders/opaque/forward-night.frag";
import type { Gpu, Program } from "../../gl/gpu.js";
import type { Mesh } from "../mesh/mesh.js";
import { VIRTUAL_LIGHTS } from "../moon/virtual-lights.js";
import type { PhysicalTier, Tier } from "../quality.js";
import { SCHEDULE } from "../schedule.js";

function definesOf({ shadow: { search, taps }, opaque }: PhysicalTier) {
  return {
    SHADOW_SEARCH: search,
    SHADOW_TAPS: taps,
    ...(opaque === "refined" && { PREPASS: 1 }),
  };
}

/** Rays by which a rough surface's reflections are traced, at rest. */
const REFLECTION_RAYS = 10;

/** `uSamples` of `forwardProgram`. */
export function samplesOf({ physical }: Tier, isMoving: boolean): readonly number[] {
  const { search, taps } = physical.shadow;
  if (!isMoving) return [search, taps, REFLECTION_RAYS];
  const { shadow, reflection } = SCHEDULE.samplesInMotion;
  // Standing candles have half the taps, of which four are filtered at once.
  const most = 8 * Math.round((taps * shadow) / 8);
  return [Math.round(search * shadow), most, REFLECTION_RAYS * reflection];
}

/** What of a mesh chooses its program. */
type Kind = Pick<Mesh, "isGlossy" | "isCutOut">;
/** Lights that a program shades for beside the carried flame. */
export interface LightsOf {
  readonly isMoonlit: boolean;
  readonly hasCandles?: boolean;
}

const GLOSSY: Kind = { isGlossy: true, isCutOut: false };

export function forwardProgram(
  gpu: Gpu,
  { physical }: Tier,
  { isMoonlit, hasCandles = false }: LightsOf,
  { isGlossy, isCutOut }: Kind = GLOSSY,
): Program {
  const defines = {
    ...definesOf(physical),
    SHADOW_BIAS: physical.shadow.bias,
    ...(isMoonlit && { MOONLIT: 1 }),
    ...(hasCandles && { CANDLES: physical.mostCandles }),
    ...(isGlossy && { GLOSSY: 1 }),
    ...(isCutOut && { CUTOUT: 1 }),
  };
  return gpu.program("opaque/forward", meshVert, forwardFrag, { defines });
}

/** Whether the programs of all kinds are compiled. Each call starts one more: some drivers compile while one waits. */
export function areForwardProgramsCompiled(
  gpu: Gpu,
  tier: Tier,
  lights: LightsOf,
  kinds: Iterable<Kind>,
): boolean {
  const programs = Array.from(kinds, (kind) => forwardProgram(gpu, tier, lights, kind));
  const hasStarted = programs.some((program) => program.start());
  return !hasStarted && programs.every(({ isCompiled }) => isCompiled);
}

/**
 * The program that multiplies radiance per candela by the light's intensity.
 *
 * @param isKept whether a part of it is clamped, as the previous frame had it and its light has moved
 */
export function forwardComposite(gpu: Gpu, isMoonlit: boolean, isKept: boolean): Program {
  const defines = { ...(isMoonlit && { MOONLIT: 1 }), ...(isKept && { KEPT: 1 }) };
  return gpu.pass("opaque/forward-composite", compositeFrag, { defines });
}

/** The program that shades all meshes of a tier for the moon alone. */
export function nightProgram(gpu: Gpu, { physical }: Tier): Program {
  const defines = { ...definesOf(physical), ...VIRTUAL_LIGHTS, CUTOUT: 1 };
  return gpu.program("opaque/forward-night", meshVert, nightFrag, { defines });
}
