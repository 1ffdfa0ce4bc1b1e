import meshVert from "../../../shaders/mesh/mesh.vert";
import forwardFrag from "../../../shaders/opaque/forward.frag";
import compositeFrag from "../../../shaders/opaque/forward-composite.frag";
import nightFrag from "../../../shaders/opaque/forward-night.frag";
import fullscreenVert from "../../../shaders/post/fullscreen.vert";
import type { Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import { VIRTUAL_LIGHTS } from "../moon/virtual-lights.js";
import type { PhysicalTier, Tier } from "../quality.js";

function definesOf({ shadow: { search, taps }, opaque }: PhysicalTier) {
  return {
    SHADOW_SEARCH: search,
    SHADOW_TAPS: taps,
    ...(opaque === "refined" && { PREPASS: 1 }),
  };
}

/** The program that shades all meshes of a tier: for the flame, for the moon as well, and for standing candles. */
export function forwardProgram(
  gpu: Gpu,
  { physical }: Tier,
  isMoonlit: boolean,
  hasCandles = false,
): Program {
  const defines = {
    ...definesOf(physical),
    SHADOW_BIAS: physical.shadow.bias,
    ...(isMoonlit && { MOONLIT: 1 }),
    ...(hasCandles && { CANDLES: physical.mostCandles }),
  };
  return gpu.program("opaque/forward", meshVert, forwardFrag, { defines });
}

/** The program that multiplies radiance per candela by the light's intensity. */
export function forwardComposite(gpu: Gpu, isMoonlit: boolean): Program {
  const options = isMoonlit ? { defines: { MOONLIT: 1 } } : {};
  return gpu.program("opaque/forward-composite", fullscreenVert, compositeFrag, options);
}

/** The program that shades all meshes of a tier for the moon alone. */
export function nightProgram(gpu: Gpu, { physical }: Tier): Program {
  const defines = { ...definesOf(physical), ...VIRTUAL_LIGHTS };
  return gpu.program("opaque/forward-night", meshVert, nightFrag, { defines });
}
