import type { CandleFlameElement, Look } from "../candle-flame-element.js";

let drawsFloats: boolean | null = null;

/** Asked for when the last `load` came. */
const looks = new WeakMap<CandleFlameElement, Look>();

/** Notes the look at each `load` from now on: before anything that asks for it then. */
export function followDrawnLook(element: CandleFlameElement): void {
  element.addEventListener("load", () => looks.set(element, element.look));
}

/** Look that was asked for when the room came that an element draws. */
export function loadedLook(element: CandleFlameElement): Look {
  return looks.get(element) ?? element.look;
}

/** Look that an element draws, which is the one before while another is loading. */
export function drawnLook(element: CandleFlameElement): Look {
  return drawnFor(loadedLook(element));
}

export function expectedLook({ look }: CandleFlameElement): Look {
  return drawnFor(look);
}

/** The paper's in place of `physical` where targets cannot hold floats. */
function drawnFor(look: Look): Look {
  if (look !== "physical") return look;
  drawsFloats ??= hasFloatTargets();
  return drawsFloats ? look : "paper";
}

function hasFloatTargets(): boolean {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 1;
  const gl = canvas.getContext("webgl2");
  const names = ["EXT_color_buffer_float", "EXT_color_buffer_half_float"];
  const hasOne = names.some((name) => gl?.getExtension(name));
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return hasOne;
}
